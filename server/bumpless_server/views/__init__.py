"""Converters beside the log's writer: the bus's messages in, other tools' out. See `bumpless.runs.view`."""

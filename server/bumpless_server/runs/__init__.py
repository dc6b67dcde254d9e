"""What was flown: the log format, the recorder, the catalogue of files."""

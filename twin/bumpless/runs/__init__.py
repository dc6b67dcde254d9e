"""Flown runs, from `fly` or from a file, and the one format of their files.

A run's file is MCAP. Every rule of the format is in this folder, and both writers, the live recorder and
`Run.save`, are the one in `writer`: fed with the same messages at the same times they write the same bytes.

- Messages are the bus's own bytes, with the bus's topics ("tlm/navigation", "event", "truth/state"), their
  log time (when they were received) and publish time (when the vehicle made them); schemas are whole
  descriptor sets; chunks are zstd. Views, such as Foxglove's topics, begin with "/" and stand beside them.
- Metadata: `bumpless.run/<id>` at the beginning identifies the run, `bumpless.end/<id>` at the end tells how
  it ended. The id is part of the name, so that two logs can be merged by any tool.
- Attachments: the mission file, the vehicle file, parameters.json, and metrics.json at the end.
- Hashes are SHA-256 of those very files: mission_sha256, vehicle_sha256, parameters_sha256.
- No clock is read: all times are those of the messages. A live recording ends a chunk with each flush, which
  is the only thing in which it differs from a run saved at once.

Files need the extra `log`; nothing here imports mcap before a file is read or written.
"""

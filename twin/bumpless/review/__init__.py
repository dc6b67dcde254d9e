"""Understanding what was flown: runs beside each other, gates for a build, and a report to send.

Above `bumpless.runs`, whose files it reads; it computes no figure of its own.
"""

"""Imported once, by the process from which the workers of this machine are forked."""

import signal

signal.signal(signal.SIGINT, signal.SIG_IGN)  # Ctrl-C is for the one that started the workers

import distributed.nanny  # noqa: E402
import distributed.worker  # noqa: E402, F401

import bumpless.campaign.flight  # noqa: E402, F401
from bumpless.campaign.ready import ready  # noqa: E402

ready()

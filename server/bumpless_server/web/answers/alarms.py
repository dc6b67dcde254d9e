"""Alarms as the API tells them."""

from bumpless.contract import bumpless_pb2 as pb
from bumpless_server.web.answers.contract import Answer, model_of


class Alarm(model_of(pb.Alarm)):
    """One alarm, from its cause to the person who saw it."""


class AlarmsAnswer(Answer):
    """Those not over, worst first, and those that are, newest first."""

    open: list[Alarm]
    history: list[Alarm]

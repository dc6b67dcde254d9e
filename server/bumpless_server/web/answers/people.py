"""Accounts, sessions and tokens, as the API tells and takes them. No secret is told but a new token's."""

from datetime import datetime

from pydantic import BaseModel, ConfigDict, Field

from bumpless_server.web.answers.contract import Answer
from bumpless_server.web.answers.control import RoleName


class _Asked(BaseModel):
    model_config = ConfigDict(extra="forbid")


class Login(_Asked):
    """Name and password of an account."""

    name: str = Field(max_length=40)
    password: str = Field(max_length=200)


class OwnPassword(_Asked):
    """A new password of one's own."""

    old: str = Field(max_length=200)
    new: str = Field(max_length=200)


class NewUser(_Asked):
    """A new account."""

    name: str = Field(max_length=40)
    role: RoleName
    password: str = Field(max_length=200)


class ChangedUser(_Asked):
    """Another role or password; what is left out stays."""

    role: RoleName | None = None
    password: str | None = Field(None, max_length=200)


class NewToken(_Asked):
    """A token for a script."""

    name: str = Field(max_length=60)
    role: RoleName
    days: float = Field(365.0, gt=0.0, le=3650.0, allow_inf_nan=False)


class UserAnswer(Answer):
    """One account."""

    name: str
    role: RoleName
    since: datetime
    sessions: int
    tokens: int


class SessionAnswer(Answer):
    """One browser that is logged in."""

    id: str
    user: str
    since: datetime
    seen: datetime
    ends: datetime
    address: str
    mine: bool


class TokenAnswer(Answer):
    """One token, without its secret."""

    id: str
    name: str
    user: str
    role: RoleName
    since: datetime
    until: datetime | None


class MadeToken(TokenAnswer):
    """A new token with its secret: told this once."""

    secret: str

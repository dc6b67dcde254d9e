"""What the actuators can do, as the API tells it."""

from typing import TYPE_CHECKING

from bumpless_server.web.answers.contract import Answer

if TYPE_CHECKING:
    from bumpless_server.foresight.reach import Reach

_PLACES = 6


class ReachAnswer(Answer):
    """Attainable force and moment sets at a speed.

    A force is inside when every row of `force` times it is at most 1, and so with moments; the largest of the
    rows times a demand is the share of the set that it uses.
    """

    sha256: str  # of the vehicle's file
    surge_mps: float  # through the water
    force: list[list[float]]  # 1/N
    moment: list[list[float]]  # 1/(N m)
    low: list[float]  # along X Y Z K M N, N and N m, whatever the other components
    high: list[float]
    most: list[float]  # the larger of both over the vehicle's speeds: a scale that holds still

    @classmethod
    def of(cls, sha256: str, reach: "Reach") -> "ReachAnswer":
        """As worked out."""
        return cls(
            sha256=sha256,
            surge_mps=round(reach.surge_mps, 3),
            force=reach.force.round(_PLACES).tolist(),
            moment=reach.moment.round(_PLACES).tolist(),
            low=reach.low.round(_PLACES).tolist(),
            high=reach.high.round(_PLACES).tolist(),
            most=reach.most.round(_PLACES).tolist(),
        )

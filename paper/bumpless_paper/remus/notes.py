"""Why some coefficients differ from the thesis by more than a few percent when its own geometry is used.

Each reason names its coefficients and, where there is one, another reading of the thesis under which our
pipeline gives what is printed: a changed vehicle, or a count. The readings are ours: the thesis does not
state them. `bumpless_paper.remus.check` computes them; tests/hydrodynamics holds them to it.
"""

from collections.abc import Callable
from dataclasses import dataclass, replace

from bumpless.config.vehicle import Vehicle
from bumpless.config.vehicle.parts import Fin, MyringHull

Change = Callable[[Vehicle], Vehicle]


@dataclass(frozen=True)
class Reason:
    """why: what makes the difference; reading: under which our pipeline gives the printed values, if any."""

    letter: str
    names: tuple[str, ...]
    why: str
    reading: str = ""
    changes: tuple[Change, ...] = ()
    factor: float = 1.0

    def read(self, vehicle: Vehicle) -> Vehicle:
        """The vehicle under the reading."""
        for change in self.changes:
            vehicle = change(vehicle)
        return vehicle


def _fins(vehicle: Vehicle, **changes: Callable[[float], float]) -> Vehicle:
    return replace(
        vehicle,
        actuators=tuple(
            replace(a, **{k: change(getattr(a, k)) for k, change in changes.items()})
            if isinstance(a, Fin)
            else a
            for a in vehicle.actuators
        ),
    )


def lower_fins(vehicle: Vehicle) -> Vehicle:
    """Fin tips 4 mm nearer the axis."""
    return _fins(vehicle, arm_m=lambda arm: arm - 0.004)


def weaker_fins(vehicle: Vehicle) -> Vehicle:
    """The efficiency of 0.9, which the printed slope of 3.12 contains, counted once more."""
    return _fins(vehicle, lift_slope_per_rad=lambda slope: 0.9 * slope)


def less_body_lift(vehicle: Vehicle) -> Vehicle:
    """c_ydb = 1.0 in place of the printed 1.2."""
    assert isinstance(vehicle.hull, MyringHull)
    return replace(vehicle, hull=replace(vehicle.hull, body_lift_slope_per_rad=1.0))


REASONS: tuple[Reason, ...] = (
    Reason(
        "a",
        ("X_qq", "X_rr", "Y_rdot", "Y_pq", "Z_qdot", "Z_rp", "M_wdot", "M_vp", "N_vdot", "N_wp"),
        "First moment of added mass, a small difference: +0.2 kg m of the bare hull less 2.3 of the fins. We "
        "take fins as slabs of mean chord; with the printed taper of 0.654 it is 2.03 instead of 2.12.",
        "fin tips 4 mm nearer the axis",
        (lower_fins,),
    ),
    Reason(
        "b",
        ("Y_rr", "Z_qq", "M_ww", "N_vv"),
        "Moments of the side view about O_b, small differences of fore and aft. The printed profile has its "
        "centre 16 mm behind O_b and its fins 0.64 m behind, so drag in heave pitches the nose down "
        "(M_ww < 0). The print contradicts itself: its M_ww needs O_b 58 mm farther aft, its Y_rr 30 mm.",
    ),
    Reason(
        "c",
        ("M_qq", "N_rr"),
        "Not geometry: a hull symmetric in both planes has M_qq = N_rr, the print has M_qq = 2 N_rr; even "
        "with all side area at the far end the hull gives no more than 49. Ten and twenty times 9.4, which "
        "is ours if the fins of both planes count in each (9.43): it looks adjusted to trials.",
    ),
    Reason(
        "d",
        ("Y_uudr", "Z_uuds", "M_uuds", "N_uudr"),
        "Slope 3.12 and fin area as printed give 10.7 N per rad at 1 m/s; the print has 0.90 of it.",
        "the fin efficiency of 0.9, which the slope of 3.12 contains, counted once more",
        (weaker_fins,),
    ),
    Reason(
        "e",
        ("Y_ur", "Z_uq", "M_uq", "N_ur"),
        "A fin term, as in d, plus an added-mass term, as in a for the moments.",
        "those of a and d",
        (lower_fins, weaker_fins),
    ),
    Reason(
        "f",
        ("Y_uv", "Z_uw"),
        "Body lift 22.5 with the printed c_ydb = 1.2 plus fins 10.7. The print less its own fin term of 9.64 "
        "leaves a body lift of 19.0.",
        "c_ydb = 1.0, and that of d",
        (less_body_lift, weaker_fins),
    ),
    Reason(
        "g",
        ("M_uw", "N_uv"),
        "Munk's 35.2 less body lift 7.2 less fins 6.8. The thesis' own printed parts, 34.6, 7.2 and 6.15, "
        "add up to 21.2, as ours do, and not to 24.0.",
        "that of f",
        (less_body_lift, weaker_fins),
    ),
    Reason(
        "h",
        ("K_pdot",),
        "The print needs fin tips 0.195 m off the axis; hull radius and span give 0.137 m.",
        "the formula for a cross of four fins counted once for each fin",
        factor=4.0,
    ),
    Reason(
        "i",
        ("K_pp",),
        "The print needs fins 0.26 m off the axis; hull radius and span give 0.094 m. It is 20 times ours, "
        "the factor of M_qq in c.",
    ),
)


def reason_of(name: str) -> Reason | None:
    """The reason of a coefficient; None where none is needed."""
    return next((reason for reason in REASONS if name in reason.names), None)

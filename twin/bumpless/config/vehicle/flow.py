"""What flow does to screws and fins beyond the published equations.

A mission's `actuator_flow` switches it on, for the simulated vehicle only: the autopilot's map has none of
it.
"""

from typing import Annotated

from bumpless.config.declare import Number, Text, model


@model
class ScrewFlow:
    """A screw in four quadrants, near a hull, across a flow, and with a motor that does not creep.

    Source: van Lammeren et al. 1969 (four quadrants); Fossen 2021, sec. 9.3 (thrust deduction); Palmer et al.
    2009 (cross-flow).
    """

    stopped_drag_coefficient: Annotated[
        float,
        Number("Drag of the stopped screw", "", 0.0, 2.0, help="On its disc, in the flow that reaches it."),
    ] = 0.0
    stopped_torque_coefficient: Annotated[
        float,
        Number("Torque of the stopped screw", "", 0.0, 2.0, help="On its disc times its diameter."),
    ] = 0.0
    opposed_thrust_slope: Annotated[
        float,
        Number("-dK_T/dJ against the flow", "", -2.0, 2.0, help="In crash-back and crash-ahead."),
    ] = 0.0
    opposed_torque_slope: Annotated[
        float, Number("-dK_Q/dJ against the flow", "", -2.0, 2.0, help="In crash-back and crash-ahead.")
    ] = 0.0
    thrust_deduction: Annotated[
        float, Number("t, thrust deduction ahead", "", 0.0, 0.9, help="The screw sucks at the hull.")
    ] = 0.0
    thrust_deduction_astern: Annotated[
        float, Number("The same astern", "", 0.0, 0.9, help="The jet meets hull and fins.")
    ] = 0.0
    cross_flow_loss_s2pm2: Annotated[
        float,
        Number("c, loss of thrust across a flow", "s²/m²", 0.0, 1000.0, help="Thrust falls by exp(-c U²)."),
    ] = 0.0
    dead_band_rpm: Annotated[float, Number("Commands below are no motion", "rpm", 0.0, 1e4)] = 0.0
    least_speed_rpm: Annotated[float, Number("Slowest speed at which it turns", "rpm", 0.0, 1e4)] = 0.0


@model
class Wash:
    """A fin in the stream of a screw, its jet or its suction, by momentum theory.

    Source: Glauert 1935 (actuator disc); McCormick 1967 (speed along the axis of a vortex cylinder).
    """

    screw: Annotated[str, Text("Name of the screw", pattern=".+", form="must not be empty")]
    share: Annotated[float, Number("Share of the fin's area in the stream", "", 0.0, 1.0)]

"""Tables 6, 7 and 8 as printed, column by column, with our definition of each figure beside it.

Source: Gao et al. 2026, tables 6 to 8 (CC BY 4.0).
"""

from dataclasses import dataclass


@dataclass(frozen=True)
class Column:
    """One column: the paper's numbers by scenario, the figure we set beside them, and its other readings."""

    name: str
    figure: str  # key of `figures.Figures`
    unit: str
    definition: str
    paper: dict[str, float]
    other: tuple[str, ...] = ()


def _rows(first: int, *values: float) -> dict[str, float]:
    return {f"S{first + i}": value for i, value in enumerate(values)}


_STEP = (
    "largest norm of the change of all commands from one cycle to the next within 2 s of the run's own first "
    "switch, commands divided by their amplitude bounds"
)

TABLE_6 = (
    Column(
        "rms_e_tau_all",
        "rms_e_tau_model",
        "N, N·m",
        "RMS over all cycles of the norm of tau_d minus the map at the commands and the estimated flow",
        _rows(1, 3.7978, 0.7836, 1.0686, 1.0719),
        ("rms_e_tau_true",),
    ),
    Column(
        "r_sat_all",
        "r_sat",
        "1",
        "share of cycles with any command at an amplitude bound",
        _rows(1, 0.0, 0.9995, 0.9991, 1.0),
        ("r_sat_increment",),
    ),
    Column(
        "d_u_FR",
        "d_u_FR_bound",
        "1",
        _STEP,
        _rows(1, 0.7248, 0.5817, 4.8027, 0.9044),
        ("d_u_FR_thrust", "d_u_FR_mixed", "d_u_FR_limit"),
    ),
    Column(
        "d_u_RH",
        "d_u_RH_bound",
        "1",
        _STEP,
        _rows(1, 0.0209, 0.1212, 0.2611, 0.0978),
        ("d_u_RH_thrust", "d_u_RH_mixed", "d_u_RH_limit"),
    ),
)

TABLE_7 = (
    Column(
        "rms_e_tau_post",
        "rms_e_tau_post_true",
        "N, N·m",
        "RMS from the fault to the end of the norm of tau_d minus the plant's true actuator wrench",
        {"S5": 1.1335, "S6": 0.9988},
        ("rms_e_tau_post_model",),
    ),
    Column(
        "d_theta_fault",
        "d_theta_fault_rms",
        "rad",
        "RMS of the true pitch about its reference from the fault to the end",
        {"S5": 0.02870, "S6": 0.02607},
        ("d_theta_fault_peak", "d_theta_fault_moved"),
    ),
    Column(
        "d_psi_fault",
        "d_psi_fault_rms",
        "rad",
        "RMS of the true heading about its reference from the fault to the end",
        {"S5": 1.4397, "S6": 2.1170},
        ("d_psi_fault_peak", "d_psi_fault_moved"),
    ),
    Column("s_max", "s_max", "N, N·m", "largest norm of the slack after the fault", {"S6": 0.01976}),
    Column("s_rms", "s_rms", "N, N·m", "RMS norm of the slack after the fault", {"S6": 0.02343}),
)

TABLE_8 = tuple(
    Column(name, f"runtime_{name}_ms", "ms", f"{about} time of the allocator in one cycle", _rows(1, *values))
    for name, about, values in (
        ("mean", "mean", (0.0192, 0.0887, 3.4195, 3.4190, 3.4183, 4.0502)),
        ("std", "standard deviation of the", (0.0484, 0.4123, 1.2371, 0.8293, 0.9007, 0.9748)),
        ("p95", "95th percentile of the", (0.0293, 0.1254, 4.8314, 4.8913, 5.2526, 5.5163)),
        ("max", "largest", (1.7855, 10.2996, 39.3173, 15.8738, 11.5384, 29.5856)),
    )
)

# Which scenario a row's relative change is taken against, by (column, scenario); "" is any other column.
REFERENCES: dict[tuple[str, str], str] = {
    ("rms_e_tau_all", "S4"): "S1",
    ("r_sat_all", "S4"): "S2",
    ("d_u_FR", "S4"): "S3",
    ("d_u_RH", "S4"): "S3",
    ("", "S6"): "S5",
}

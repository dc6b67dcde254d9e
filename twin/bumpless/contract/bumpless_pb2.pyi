from google.protobuf.internal import containers as _containers
from google.protobuf.internal import enum_type_wrapper as _enum_type_wrapper
from google.protobuf import descriptor as _descriptor
from google.protobuf import message as _message
from collections.abc import Iterable as _Iterable, Mapping as _Mapping
from typing import ClassVar as _ClassVar, Optional as _Optional, Union as _Union

DESCRIPTOR: _descriptor.FileDescriptor

class Mode(int, metaclass=_enum_type_wrapper.EnumTypeWrapper):
    __slots__ = ()
    MODE_UNSPECIFIED: _ClassVar[Mode]
    MODE_FORWARD: _ClassVar[Mode]
    MODE_REVERSE: _ClassVar[Mode]
    MODE_HOVER: _ClassVar[Mode]

class MissionPhase(int, metaclass=_enum_type_wrapper.EnumTypeWrapper):
    __slots__ = ()
    MISSION_PHASE_UNSPECIFIED: _ClassVar[MissionPhase]
    MISSION_PHASE_IDLE: _ClassVar[MissionPhase]
    MISSION_PHASE_RUNNING: _ClassVar[MissionPhase]
    MISSION_PHASE_PAUSED: _ClassVar[MissionPhase]
    MISSION_PHASE_COMPLETED: _ClassVar[MissionPhase]
    MISSION_PHASE_ABORTED: _ClassVar[MissionPhase]

class SolveStatus(int, metaclass=_enum_type_wrapper.EnumTypeWrapper):
    __slots__ = ()
    SOLVE_STATUS_UNSPECIFIED: _ClassVar[SolveStatus]
    SOLVE_STATUS_SOLVED: _ClassVar[SolveStatus]
    SOLVE_STATUS_BUDGET_SPENT: _ClassVar[SolveStatus]
    SOLVE_STATUS_INFEASIBLE: _ClassVar[SolveStatus]
    SOLVE_STATUS_FALLBACK: _ClassVar[SolveStatus]
    SOLVE_STATUS_REFUSED: _ClassVar[SolveStatus]

class Severity(int, metaclass=_enum_type_wrapper.EnumTypeWrapper):
    __slots__ = ()
    SEVERITY_UNSPECIFIED: _ClassVar[Severity]
    SEVERITY_INFO: _ClassVar[Severity]
    SEVERITY_WARNING: _ClassVar[Severity]
    SEVERITY_ALARM: _ClassVar[Severity]

class DockingStage(int, metaclass=_enum_type_wrapper.EnumTypeWrapper):
    __slots__ = ()
    DOCKING_STAGE_UNSPECIFIED: _ClassVar[DockingStage]
    DOCKING_STAGE_TRANSIT: _ClassVar[DockingStage]
    DOCKING_STAGE_ENTRY: _ClassVar[DockingStage]
    DOCKING_STAGE_APPROACH: _ClassVar[DockingStage]
    DOCKING_STAGE_BACK: _ClassVar[DockingStage]
    DOCKING_STAGE_HOLD: _ClassVar[DockingStage]
    DOCKING_STAGE_CREEP: _ClassVar[DockingStage]
    DOCKING_STAGE_CAPTURED: _ClassVar[DockingStage]

class WaveOffReason(int, metaclass=_enum_type_wrapper.EnumTypeWrapper):
    __slots__ = ()
    WAVE_OFF_REASON_UNSPECIFIED: _ClassVar[WaveOffReason]
    WAVE_OFF_REASON_TARGET_LOST: _ClassVar[WaveOffReason]
    WAVE_OFF_REASON_OFF_LINE: _ClassVar[WaveOffReason]
    WAVE_OFF_REASON_OFF_HEADING: _ClassVar[WaveOffReason]
    WAVE_OFF_REASON_OFF_DEPTH: _ClassVar[WaveOffReason]
    WAVE_OFF_REASON_OVERSHOT: _ClassVar[WaveOffReason]
    WAVE_OFF_REASON_STUCK_AT_GATE: _ClassVar[WaveOffReason]
    WAVE_OFF_REASON_NOT_SEEN: _ClassVar[WaveOffReason]
    WAVE_OFF_REASON_TOO_SLOW: _ClassVar[WaveOffReason]
    WAVE_OFF_REASON_CURRENT: _ClassVar[WaveOffReason]
    WAVE_OFF_REASON_TIME_OVER: _ClassVar[WaveOffReason]
    WAVE_OFF_REASON_FAILSAFE: _ClassVar[WaveOffReason]

class RefusalCause(int, metaclass=_enum_type_wrapper.EnumTypeWrapper):
    __slots__ = ()
    REFUSAL_CAUSE_UNSPECIFIED: _ClassVar[RefusalCause]
    REFUSAL_CAUSE_LATE: _ClassVar[RefusalCause]
    REFUSAL_CAUSE_BUSY: _ClassVar[RefusalCause]
    REFUSAL_CAUSE_OVERTAKEN: _ClassVar[RefusalCause]
    REFUSAL_CAUSE_STALE_REVISION: _ClassVar[RefusalCause]
    REFUSAL_CAUSE_NO_HEADER: _ClassVar[RefusalCause]
    REFUSAL_CAUSE_NOT_ADDRESSED: _ClassVar[RefusalCause]

class Ending(int, metaclass=_enum_type_wrapper.EnumTypeWrapper):
    __slots__ = ()
    ENDING_UNSPECIFIED: _ClassVar[Ending]
    ENDING_DOCKED: _ClassVar[Ending]
    ENDING_HELD: _ClassVar[Ending]
    ENDING_WAVED_OFF: _ClassVar[Ending]
    ENDING_TIME_OVER: _ClassVar[Ending]
    ENDING_ABORTED: _ClassVar[Ending]
    ENDING_COLLIDED: _ClassVar[Ending]
    ENDING_INTERRUPTED: _ClassVar[Ending]

class LinkState(int, metaclass=_enum_type_wrapper.EnumTypeWrapper):
    __slots__ = ()
    LINK_STATE_UNSPECIFIED: _ClassVar[LinkState]
    LINK_STATE_WAITING: _ClassVar[LinkState]
    LINK_STATE_LIVE: _ClassVar[LinkState]
    LINK_STATE_STALE: _ClassVar[LinkState]
    LINK_STATE_LOST: _ClassVar[LinkState]
MODE_UNSPECIFIED: Mode
MODE_FORWARD: Mode
MODE_REVERSE: Mode
MODE_HOVER: Mode
MISSION_PHASE_UNSPECIFIED: MissionPhase
MISSION_PHASE_IDLE: MissionPhase
MISSION_PHASE_RUNNING: MissionPhase
MISSION_PHASE_PAUSED: MissionPhase
MISSION_PHASE_COMPLETED: MissionPhase
MISSION_PHASE_ABORTED: MissionPhase
SOLVE_STATUS_UNSPECIFIED: SolveStatus
SOLVE_STATUS_SOLVED: SolveStatus
SOLVE_STATUS_BUDGET_SPENT: SolveStatus
SOLVE_STATUS_INFEASIBLE: SolveStatus
SOLVE_STATUS_FALLBACK: SolveStatus
SOLVE_STATUS_REFUSED: SolveStatus
SEVERITY_UNSPECIFIED: Severity
SEVERITY_INFO: Severity
SEVERITY_WARNING: Severity
SEVERITY_ALARM: Severity
DOCKING_STAGE_UNSPECIFIED: DockingStage
DOCKING_STAGE_TRANSIT: DockingStage
DOCKING_STAGE_ENTRY: DockingStage
DOCKING_STAGE_APPROACH: DockingStage
DOCKING_STAGE_BACK: DockingStage
DOCKING_STAGE_HOLD: DockingStage
DOCKING_STAGE_CREEP: DockingStage
DOCKING_STAGE_CAPTURED: DockingStage
WAVE_OFF_REASON_UNSPECIFIED: WaveOffReason
WAVE_OFF_REASON_TARGET_LOST: WaveOffReason
WAVE_OFF_REASON_OFF_LINE: WaveOffReason
WAVE_OFF_REASON_OFF_HEADING: WaveOffReason
WAVE_OFF_REASON_OFF_DEPTH: WaveOffReason
WAVE_OFF_REASON_OVERSHOT: WaveOffReason
WAVE_OFF_REASON_STUCK_AT_GATE: WaveOffReason
WAVE_OFF_REASON_NOT_SEEN: WaveOffReason
WAVE_OFF_REASON_TOO_SLOW: WaveOffReason
WAVE_OFF_REASON_CURRENT: WaveOffReason
WAVE_OFF_REASON_TIME_OVER: WaveOffReason
WAVE_OFF_REASON_FAILSAFE: WaveOffReason
REFUSAL_CAUSE_UNSPECIFIED: RefusalCause
REFUSAL_CAUSE_LATE: RefusalCause
REFUSAL_CAUSE_BUSY: RefusalCause
REFUSAL_CAUSE_OVERTAKEN: RefusalCause
REFUSAL_CAUSE_STALE_REVISION: RefusalCause
REFUSAL_CAUSE_NO_HEADER: RefusalCause
REFUSAL_CAUSE_NOT_ADDRESSED: RefusalCause
ENDING_UNSPECIFIED: Ending
ENDING_DOCKED: Ending
ENDING_HELD: Ending
ENDING_WAVED_OFF: Ending
ENDING_TIME_OVER: Ending
ENDING_ABORTED: Ending
ENDING_COLLIDED: Ending
ENDING_INTERRUPTED: Ending
LINK_STATE_UNSPECIFIED: LinkState
LINK_STATE_WAITING: LinkState
LINK_STATE_LIVE: LinkState
LINK_STATE_STALE: LinkState
LINK_STATE_LOST: LinkState

class Vector3(_message.Message):
    __slots__ = ("x", "y", "z")
    X_FIELD_NUMBER: _ClassVar[int]
    Y_FIELD_NUMBER: _ClassVar[int]
    Z_FIELD_NUMBER: _ClassVar[int]
    x: float
    y: float
    z: float
    def __init__(self, x: _Optional[float] = ..., y: _Optional[float] = ..., z: _Optional[float] = ...) -> None: ...

class Attitude(_message.Message):
    __slots__ = ("roll_deg", "pitch_deg", "yaw_deg")
    ROLL_DEG_FIELD_NUMBER: _ClassVar[int]
    PITCH_DEG_FIELD_NUMBER: _ClassVar[int]
    YAW_DEG_FIELD_NUMBER: _ClassVar[int]
    roll_deg: float
    pitch_deg: float
    yaw_deg: float
    def __init__(self, roll_deg: _Optional[float] = ..., pitch_deg: _Optional[float] = ..., yaw_deg: _Optional[float] = ...) -> None: ...

class Wrench(_message.Message):
    __slots__ = ("x_n", "y_n", "z_n", "k_nm", "m_nm", "n_nm")
    X_N_FIELD_NUMBER: _ClassVar[int]
    Y_N_FIELD_NUMBER: _ClassVar[int]
    Z_N_FIELD_NUMBER: _ClassVar[int]
    K_NM_FIELD_NUMBER: _ClassVar[int]
    M_NM_FIELD_NUMBER: _ClassVar[int]
    N_NM_FIELD_NUMBER: _ClassVar[int]
    x_n: float
    y_n: float
    z_n: float
    k_nm: float
    m_nm: float
    n_nm: float
    def __init__(self, x_n: _Optional[float] = ..., y_n: _Optional[float] = ..., z_n: _Optional[float] = ..., k_nm: _Optional[float] = ..., m_nm: _Optional[float] = ..., n_nm: _Optional[float] = ...) -> None: ...

class Stamp(_message.Message):
    __slots__ = ("time_ns", "mission_time_s", "cycle")
    TIME_NS_FIELD_NUMBER: _ClassVar[int]
    MISSION_TIME_S_FIELD_NUMBER: _ClassVar[int]
    CYCLE_FIELD_NUMBER: _ClassVar[int]
    time_ns: int
    mission_time_s: float
    cycle: int
    def __init__(self, time_ns: _Optional[int] = ..., mission_time_s: _Optional[float] = ..., cycle: _Optional[int] = ...) -> None: ...

class Navigation(_message.Message):
    __slots__ = ("stamp", "position_ned_m", "attitude", "velocity_body_mps", "velocity_through_water_body_mps", "angular_rate_body_degps", "depth_m", "speed_over_ground_mps", "current_estimate_ned_mps")
    STAMP_FIELD_NUMBER: _ClassVar[int]
    POSITION_NED_M_FIELD_NUMBER: _ClassVar[int]
    ATTITUDE_FIELD_NUMBER: _ClassVar[int]
    VELOCITY_BODY_MPS_FIELD_NUMBER: _ClassVar[int]
    VELOCITY_THROUGH_WATER_BODY_MPS_FIELD_NUMBER: _ClassVar[int]
    ANGULAR_RATE_BODY_DEGPS_FIELD_NUMBER: _ClassVar[int]
    DEPTH_M_FIELD_NUMBER: _ClassVar[int]
    SPEED_OVER_GROUND_MPS_FIELD_NUMBER: _ClassVar[int]
    CURRENT_ESTIMATE_NED_MPS_FIELD_NUMBER: _ClassVar[int]
    stamp: Stamp
    position_ned_m: Vector3
    attitude: Attitude
    velocity_body_mps: Vector3
    velocity_through_water_body_mps: Vector3
    angular_rate_body_degps: Vector3
    depth_m: float
    speed_over_ground_mps: float
    current_estimate_ned_mps: Vector3
    def __init__(self, stamp: _Optional[_Union[Stamp, _Mapping]] = ..., position_ned_m: _Optional[_Union[Vector3, _Mapping]] = ..., attitude: _Optional[_Union[Attitude, _Mapping]] = ..., velocity_body_mps: _Optional[_Union[Vector3, _Mapping]] = ..., velocity_through_water_body_mps: _Optional[_Union[Vector3, _Mapping]] = ..., angular_rate_body_degps: _Optional[_Union[Vector3, _Mapping]] = ..., depth_m: _Optional[float] = ..., speed_over_ground_mps: _Optional[float] = ..., current_estimate_ned_mps: _Optional[_Union[Vector3, _Mapping]] = ...) -> None: ...

class Guidance(_message.Message):
    __slots__ = ("stamp", "surge_speed_reference_mps", "depth_reference_m", "attitude_reference", "cross_track_error_m", "along_track_error_m", "leg", "leg_count", "sway_speed_reference_mps")
    STAMP_FIELD_NUMBER: _ClassVar[int]
    SURGE_SPEED_REFERENCE_MPS_FIELD_NUMBER: _ClassVar[int]
    DEPTH_REFERENCE_M_FIELD_NUMBER: _ClassVar[int]
    ATTITUDE_REFERENCE_FIELD_NUMBER: _ClassVar[int]
    CROSS_TRACK_ERROR_M_FIELD_NUMBER: _ClassVar[int]
    ALONG_TRACK_ERROR_M_FIELD_NUMBER: _ClassVar[int]
    LEG_FIELD_NUMBER: _ClassVar[int]
    LEG_COUNT_FIELD_NUMBER: _ClassVar[int]
    SWAY_SPEED_REFERENCE_MPS_FIELD_NUMBER: _ClassVar[int]
    stamp: Stamp
    surge_speed_reference_mps: float
    depth_reference_m: float
    attitude_reference: Attitude
    cross_track_error_m: float
    along_track_error_m: float
    leg: int
    leg_count: int
    sway_speed_reference_mps: float
    def __init__(self, stamp: _Optional[_Union[Stamp, _Mapping]] = ..., surge_speed_reference_mps: _Optional[float] = ..., depth_reference_m: _Optional[float] = ..., attitude_reference: _Optional[_Union[Attitude, _Mapping]] = ..., cross_track_error_m: _Optional[float] = ..., along_track_error_m: _Optional[float] = ..., leg: _Optional[int] = ..., leg_count: _Optional[int] = ..., sway_speed_reference_mps: _Optional[float] = ...) -> None: ...

class Supervisor(_message.Message):
    __slots__ = ("stamp", "mode", "previous_mode", "range_m", "detection_raw", "detection", "kappa", "time_in_mode_s", "dwell_remaining_s", "range_rh_lower_m", "range_rh_upper_m", "range_fr_lower_m", "range_fr_upper_m", "range_hf_upper_m", "phase", "docking_stage", "docking_tries", "docking_tries_most", "wave_off_reason", "approach_heading_deg", "fix_age_s", "captured", "flown")
    STAMP_FIELD_NUMBER: _ClassVar[int]
    MODE_FIELD_NUMBER: _ClassVar[int]
    PREVIOUS_MODE_FIELD_NUMBER: _ClassVar[int]
    RANGE_M_FIELD_NUMBER: _ClassVar[int]
    DETECTION_RAW_FIELD_NUMBER: _ClassVar[int]
    DETECTION_FIELD_NUMBER: _ClassVar[int]
    KAPPA_FIELD_NUMBER: _ClassVar[int]
    TIME_IN_MODE_S_FIELD_NUMBER: _ClassVar[int]
    DWELL_REMAINING_S_FIELD_NUMBER: _ClassVar[int]
    RANGE_RH_LOWER_M_FIELD_NUMBER: _ClassVar[int]
    RANGE_RH_UPPER_M_FIELD_NUMBER: _ClassVar[int]
    RANGE_FR_LOWER_M_FIELD_NUMBER: _ClassVar[int]
    RANGE_FR_UPPER_M_FIELD_NUMBER: _ClassVar[int]
    RANGE_HF_UPPER_M_FIELD_NUMBER: _ClassVar[int]
    PHASE_FIELD_NUMBER: _ClassVar[int]
    DOCKING_STAGE_FIELD_NUMBER: _ClassVar[int]
    DOCKING_TRIES_FIELD_NUMBER: _ClassVar[int]
    DOCKING_TRIES_MOST_FIELD_NUMBER: _ClassVar[int]
    WAVE_OFF_REASON_FIELD_NUMBER: _ClassVar[int]
    APPROACH_HEADING_DEG_FIELD_NUMBER: _ClassVar[int]
    FIX_AGE_S_FIELD_NUMBER: _ClassVar[int]
    CAPTURED_FIELD_NUMBER: _ClassVar[int]
    FLOWN_FIELD_NUMBER: _ClassVar[int]
    stamp: Stamp
    mode: Mode
    previous_mode: Mode
    range_m: float
    detection_raw: bool
    detection: bool
    kappa: float
    time_in_mode_s: float
    dwell_remaining_s: float
    range_rh_lower_m: float
    range_rh_upper_m: float
    range_fr_lower_m: float
    range_fr_upper_m: float
    range_hf_upper_m: float
    phase: MissionPhase
    docking_stage: DockingStage
    docking_tries: int
    docking_tries_most: int
    wave_off_reason: WaveOffReason
    approach_heading_deg: float
    fix_age_s: float
    captured: bool
    flown: Mode
    def __init__(self, stamp: _Optional[_Union[Stamp, _Mapping]] = ..., mode: _Optional[_Union[Mode, str]] = ..., previous_mode: _Optional[_Union[Mode, str]] = ..., range_m: _Optional[float] = ..., detection_raw: _Optional[bool] = ..., detection: _Optional[bool] = ..., kappa: _Optional[float] = ..., time_in_mode_s: _Optional[float] = ..., dwell_remaining_s: _Optional[float] = ..., range_rh_lower_m: _Optional[float] = ..., range_rh_upper_m: _Optional[float] = ..., range_fr_lower_m: _Optional[float] = ..., range_fr_upper_m: _Optional[float] = ..., range_hf_upper_m: _Optional[float] = ..., phase: _Optional[_Union[MissionPhase, str]] = ..., docking_stage: _Optional[_Union[DockingStage, str]] = ..., docking_tries: _Optional[int] = ..., docking_tries_most: _Optional[int] = ..., wave_off_reason: _Optional[_Union[WaveOffReason, str]] = ..., approach_heading_deg: _Optional[float] = ..., fix_age_s: _Optional[float] = ..., captured: _Optional[bool] = ..., flown: _Optional[_Union[Mode, str]] = ...) -> None: ...

class Guard(_message.Message):
    __slots__ = ("name", "value", "limit", "at_least", "met", "unit")
    NAME_FIELD_NUMBER: _ClassVar[int]
    VALUE_FIELD_NUMBER: _ClassVar[int]
    LIMIT_FIELD_NUMBER: _ClassVar[int]
    AT_LEAST_FIELD_NUMBER: _ClassVar[int]
    MET_FIELD_NUMBER: _ClassVar[int]
    UNIT_FIELD_NUMBER: _ClassVar[int]
    name: str
    value: float
    limit: float
    at_least: bool
    met: bool
    unit: str
    def __init__(self, name: _Optional[str] = ..., value: _Optional[float] = ..., limit: _Optional[float] = ..., at_least: _Optional[bool] = ..., met: _Optional[bool] = ..., unit: _Optional[str] = ...) -> None: ...

class ModeExit(_message.Message):
    __slots__ = ("to", "name", "guards", "expected_s")
    TO_FIELD_NUMBER: _ClassVar[int]
    NAME_FIELD_NUMBER: _ClassVar[int]
    GUARDS_FIELD_NUMBER: _ClassVar[int]
    EXPECTED_S_FIELD_NUMBER: _ClassVar[int]
    to: Mode
    name: str
    guards: _containers.RepeatedCompositeFieldContainer[Guard]
    expected_s: float
    def __init__(self, to: _Optional[_Union[Mode, str]] = ..., name: _Optional[str] = ..., guards: _Optional[_Iterable[_Union[Guard, _Mapping]]] = ..., expected_s: _Optional[float] = ...) -> None: ...

class Exits(_message.Message):
    __slots__ = ("stamp", "mode", "exits")
    STAMP_FIELD_NUMBER: _ClassVar[int]
    MODE_FIELD_NUMBER: _ClassVar[int]
    EXITS_FIELD_NUMBER: _ClassVar[int]
    stamp: Stamp
    mode: Mode
    exits: _containers.RepeatedCompositeFieldContainer[ModeExit]
    def __init__(self, stamp: _Optional[_Union[Stamp, _Mapping]] = ..., mode: _Optional[_Union[Mode, str]] = ..., exits: _Optional[_Iterable[_Union[ModeExit, _Mapping]]] = ...) -> None: ...

class Control(_message.Message):
    __slots__ = ("stamp", "demanded", "demanded_raw", "achieved", "residual", "frozen")
    STAMP_FIELD_NUMBER: _ClassVar[int]
    DEMANDED_FIELD_NUMBER: _ClassVar[int]
    DEMANDED_RAW_FIELD_NUMBER: _ClassVar[int]
    ACHIEVED_FIELD_NUMBER: _ClassVar[int]
    RESIDUAL_FIELD_NUMBER: _ClassVar[int]
    FROZEN_FIELD_NUMBER: _ClassVar[int]
    stamp: Stamp
    demanded: Wrench
    demanded_raw: Wrench
    achieved: Wrench
    residual: Wrench
    frozen: Wrench
    def __init__(self, stamp: _Optional[_Union[Stamp, _Mapping]] = ..., demanded: _Optional[_Union[Wrench, _Mapping]] = ..., demanded_raw: _Optional[_Union[Wrench, _Mapping]] = ..., achieved: _Optional[_Union[Wrench, _Mapping]] = ..., residual: _Optional[_Union[Wrench, _Mapping]] = ..., frozen: _Optional[_Union[Wrench, _Mapping]] = ...) -> None: ...

class Allocation(_message.Message):
    __slots__ = ("stamp", "status", "sqp_iterations", "kkt_residual", "residual_norm", "cost", "solve_time_us", "saturated_count", "solver", "slack_norm")
    STAMP_FIELD_NUMBER: _ClassVar[int]
    STATUS_FIELD_NUMBER: _ClassVar[int]
    SQP_ITERATIONS_FIELD_NUMBER: _ClassVar[int]
    KKT_RESIDUAL_FIELD_NUMBER: _ClassVar[int]
    RESIDUAL_NORM_FIELD_NUMBER: _ClassVar[int]
    COST_FIELD_NUMBER: _ClassVar[int]
    SOLVE_TIME_US_FIELD_NUMBER: _ClassVar[int]
    SATURATED_COUNT_FIELD_NUMBER: _ClassVar[int]
    SOLVER_FIELD_NUMBER: _ClassVar[int]
    SLACK_NORM_FIELD_NUMBER: _ClassVar[int]
    stamp: Stamp
    status: SolveStatus
    sqp_iterations: int
    kkt_residual: float
    residual_norm: float
    cost: float
    solve_time_us: float
    saturated_count: int
    solver: str
    slack_norm: float
    def __init__(self, stamp: _Optional[_Union[Stamp, _Mapping]] = ..., status: _Optional[_Union[SolveStatus, str]] = ..., sqp_iterations: _Optional[int] = ..., kkt_residual: _Optional[float] = ..., residual_norm: _Optional[float] = ..., cost: _Optional[float] = ..., solve_time_us: _Optional[float] = ..., saturated_count: _Optional[int] = ..., solver: _Optional[str] = ..., slack_norm: _Optional[float] = ...) -> None: ...

class Actuator(_message.Message):
    __slots__ = ("name", "unit", "command", "feedback", "lower", "upper", "amplitude_lower", "amplitude_upper", "saturated", "rate_limited", "increment_bound", "effectiveness", "fault_evidence", "faulty")
    NAME_FIELD_NUMBER: _ClassVar[int]
    UNIT_FIELD_NUMBER: _ClassVar[int]
    COMMAND_FIELD_NUMBER: _ClassVar[int]
    FEEDBACK_FIELD_NUMBER: _ClassVar[int]
    LOWER_FIELD_NUMBER: _ClassVar[int]
    UPPER_FIELD_NUMBER: _ClassVar[int]
    AMPLITUDE_LOWER_FIELD_NUMBER: _ClassVar[int]
    AMPLITUDE_UPPER_FIELD_NUMBER: _ClassVar[int]
    SATURATED_FIELD_NUMBER: _ClassVar[int]
    RATE_LIMITED_FIELD_NUMBER: _ClassVar[int]
    INCREMENT_BOUND_FIELD_NUMBER: _ClassVar[int]
    EFFECTIVENESS_FIELD_NUMBER: _ClassVar[int]
    FAULT_EVIDENCE_FIELD_NUMBER: _ClassVar[int]
    FAULTY_FIELD_NUMBER: _ClassVar[int]
    name: str
    unit: str
    command: float
    feedback: float
    lower: float
    upper: float
    amplitude_lower: float
    amplitude_upper: float
    saturated: bool
    rate_limited: bool
    increment_bound: float
    effectiveness: float
    fault_evidence: float
    faulty: bool
    def __init__(self, name: _Optional[str] = ..., unit: _Optional[str] = ..., command: _Optional[float] = ..., feedback: _Optional[float] = ..., lower: _Optional[float] = ..., upper: _Optional[float] = ..., amplitude_lower: _Optional[float] = ..., amplitude_upper: _Optional[float] = ..., saturated: _Optional[bool] = ..., rate_limited: _Optional[bool] = ..., increment_bound: _Optional[float] = ..., effectiveness: _Optional[float] = ..., fault_evidence: _Optional[float] = ..., faulty: _Optional[bool] = ...) -> None: ...

class Actuators(_message.Message):
    __slots__ = ("stamp", "actuators")
    STAMP_FIELD_NUMBER: _ClassVar[int]
    ACTUATORS_FIELD_NUMBER: _ClassVar[int]
    stamp: Stamp
    actuators: _containers.RepeatedCompositeFieldContainer[Actuator]
    def __init__(self, stamp: _Optional[_Union[Stamp, _Mapping]] = ..., actuators: _Optional[_Iterable[_Union[Actuator, _Mapping]]] = ...) -> None: ...

class Target(_message.Message):
    __slots__ = ("stamp", "detected", "measured_range_m", "bearing_deg", "elevation_deg", "position_ned_m", "heading_deg", "observation_point_ned_m")
    STAMP_FIELD_NUMBER: _ClassVar[int]
    DETECTED_FIELD_NUMBER: _ClassVar[int]
    MEASURED_RANGE_M_FIELD_NUMBER: _ClassVar[int]
    BEARING_DEG_FIELD_NUMBER: _ClassVar[int]
    ELEVATION_DEG_FIELD_NUMBER: _ClassVar[int]
    POSITION_NED_M_FIELD_NUMBER: _ClassVar[int]
    HEADING_DEG_FIELD_NUMBER: _ClassVar[int]
    OBSERVATION_POINT_NED_M_FIELD_NUMBER: _ClassVar[int]
    stamp: Stamp
    detected: bool
    measured_range_m: float
    bearing_deg: float
    elevation_deg: float
    position_ned_m: Vector3
    heading_deg: float
    observation_point_ned_m: Vector3
    def __init__(self, stamp: _Optional[_Union[Stamp, _Mapping]] = ..., detected: _Optional[bool] = ..., measured_range_m: _Optional[float] = ..., bearing_deg: _Optional[float] = ..., elevation_deg: _Optional[float] = ..., position_ned_m: _Optional[_Union[Vector3, _Mapping]] = ..., heading_deg: _Optional[float] = ..., observation_point_ned_m: _Optional[_Union[Vector3, _Mapping]] = ...) -> None: ...

class MissionStatus(_message.Message):
    __slots__ = ("stamp", "phase", "run_id", "mission_name", "mission_sha256", "duration_s", "elapsed_s", "seed", "end_reason", "held_s")
    STAMP_FIELD_NUMBER: _ClassVar[int]
    PHASE_FIELD_NUMBER: _ClassVar[int]
    RUN_ID_FIELD_NUMBER: _ClassVar[int]
    MISSION_NAME_FIELD_NUMBER: _ClassVar[int]
    MISSION_SHA256_FIELD_NUMBER: _ClassVar[int]
    DURATION_S_FIELD_NUMBER: _ClassVar[int]
    ELAPSED_S_FIELD_NUMBER: _ClassVar[int]
    SEED_FIELD_NUMBER: _ClassVar[int]
    END_REASON_FIELD_NUMBER: _ClassVar[int]
    HELD_S_FIELD_NUMBER: _ClassVar[int]
    stamp: Stamp
    phase: MissionPhase
    run_id: str
    mission_name: str
    mission_sha256: str
    duration_s: float
    elapsed_s: float
    seed: int
    end_reason: str
    held_s: float
    def __init__(self, stamp: _Optional[_Union[Stamp, _Mapping]] = ..., phase: _Optional[_Union[MissionPhase, str]] = ..., run_id: _Optional[str] = ..., mission_name: _Optional[str] = ..., mission_sha256: _Optional[str] = ..., duration_s: _Optional[float] = ..., elapsed_s: _Optional[float] = ..., seed: _Optional[int] = ..., end_reason: _Optional[str] = ..., held_s: _Optional[float] = ...) -> None: ...

class Plan(_message.Message):
    __slots__ = ("stamp", "file_name", "mission_yaml", "sha256", "path_ned_m")
    STAMP_FIELD_NUMBER: _ClassVar[int]
    FILE_NAME_FIELD_NUMBER: _ClassVar[int]
    MISSION_YAML_FIELD_NUMBER: _ClassVar[int]
    SHA256_FIELD_NUMBER: _ClassVar[int]
    PATH_NED_M_FIELD_NUMBER: _ClassVar[int]
    stamp: Stamp
    file_name: str
    mission_yaml: str
    sha256: str
    path_ned_m: _containers.RepeatedCompositeFieldContainer[Vector3]
    def __init__(self, stamp: _Optional[_Union[Stamp, _Mapping]] = ..., file_name: _Optional[str] = ..., mission_yaml: _Optional[str] = ..., sha256: _Optional[str] = ..., path_ned_m: _Optional[_Iterable[_Union[Vector3, _Mapping]]] = ...) -> None: ...

class ModeParameters(_message.Message):
    __slots__ = ("q_diagonal", "r_diagonal", "ramp_cycles")
    Q_DIAGONAL_FIELD_NUMBER: _ClassVar[int]
    R_DIAGONAL_FIELD_NUMBER: _ClassVar[int]
    LAMBDA_FIELD_NUMBER: _ClassVar[int]
    RAMP_CYCLES_FIELD_NUMBER: _ClassVar[int]
    q_diagonal: _containers.RepeatedScalarFieldContainer[float]
    r_diagonal: _containers.RepeatedScalarFieldContainer[float]
    ramp_cycles: int
    def __init__(self, q_diagonal: _Optional[_Iterable[float]] = ..., r_diagonal: _Optional[_Iterable[float]] = ..., ramp_cycles: _Optional[int] = ..., **kwargs) -> None: ...

class SupervisorParameters(_message.Message):
    __slots__ = ("range_rh_lower_m", "range_rh_upper_m", "range_fr_lower_m", "range_fr_upper_m", "range_hf_upper_m", "dwell_cycles", "detection_hits", "detection_window", "detection_hold_cycles")
    RANGE_RH_LOWER_M_FIELD_NUMBER: _ClassVar[int]
    RANGE_RH_UPPER_M_FIELD_NUMBER: _ClassVar[int]
    RANGE_FR_LOWER_M_FIELD_NUMBER: _ClassVar[int]
    RANGE_FR_UPPER_M_FIELD_NUMBER: _ClassVar[int]
    RANGE_HF_UPPER_M_FIELD_NUMBER: _ClassVar[int]
    DWELL_CYCLES_FIELD_NUMBER: _ClassVar[int]
    DETECTION_HITS_FIELD_NUMBER: _ClassVar[int]
    DETECTION_WINDOW_FIELD_NUMBER: _ClassVar[int]
    DETECTION_HOLD_CYCLES_FIELD_NUMBER: _ClassVar[int]
    range_rh_lower_m: float
    range_rh_upper_m: float
    range_fr_lower_m: float
    range_fr_upper_m: float
    range_hf_upper_m: float
    dwell_cycles: int
    detection_hits: int
    detection_window: int
    detection_hold_cycles: int
    def __init__(self, range_rh_lower_m: _Optional[float] = ..., range_rh_upper_m: _Optional[float] = ..., range_fr_lower_m: _Optional[float] = ..., range_fr_upper_m: _Optional[float] = ..., range_hf_upper_m: _Optional[float] = ..., dwell_cycles: _Optional[int] = ..., detection_hits: _Optional[int] = ..., detection_window: _Optional[int] = ..., detection_hold_cycles: _Optional[int] = ...) -> None: ...

class BumplessParameters(_message.Message):
    __slots__ = ("ramp", "integrator_alignment", "warm_start_projection")
    RAMP_FIELD_NUMBER: _ClassVar[int]
    INTEGRATOR_ALIGNMENT_FIELD_NUMBER: _ClassVar[int]
    WARM_START_PROJECTION_FIELD_NUMBER: _ClassVar[int]
    ramp: bool
    integrator_alignment: bool
    warm_start_projection: bool
    def __init__(self, ramp: _Optional[bool] = ..., integrator_alignment: _Optional[bool] = ..., warm_start_projection: _Optional[bool] = ...) -> None: ...

class Parameters(_message.Message):
    __slots__ = ("forward", "reverse", "hover", "supervisor", "bumpless")
    FORWARD_FIELD_NUMBER: _ClassVar[int]
    REVERSE_FIELD_NUMBER: _ClassVar[int]
    HOVER_FIELD_NUMBER: _ClassVar[int]
    SUPERVISOR_FIELD_NUMBER: _ClassVar[int]
    BUMPLESS_FIELD_NUMBER: _ClassVar[int]
    forward: ModeParameters
    reverse: ModeParameters
    hover: ModeParameters
    supervisor: SupervisorParameters
    bumpless: BumplessParameters
    def __init__(self, forward: _Optional[_Union[ModeParameters, _Mapping]] = ..., reverse: _Optional[_Union[ModeParameters, _Mapping]] = ..., hover: _Optional[_Union[ModeParameters, _Mapping]] = ..., supervisor: _Optional[_Union[SupervisorParameters, _Mapping]] = ..., bumpless: _Optional[_Union[BumplessParameters, _Mapping]] = ...) -> None: ...

class ParametersStatus(_message.Message):
    __slots__ = ("stamp", "active", "revision", "sha256", "defaults", "parameters_json")
    STAMP_FIELD_NUMBER: _ClassVar[int]
    ACTIVE_FIELD_NUMBER: _ClassVar[int]
    REVISION_FIELD_NUMBER: _ClassVar[int]
    SHA256_FIELD_NUMBER: _ClassVar[int]
    DEFAULTS_FIELD_NUMBER: _ClassVar[int]
    PARAMETERS_JSON_FIELD_NUMBER: _ClassVar[int]
    stamp: Stamp
    active: Parameters
    revision: int
    sha256: str
    defaults: Parameters
    parameters_json: str
    def __init__(self, stamp: _Optional[_Union[Stamp, _Mapping]] = ..., active: _Optional[_Union[Parameters, _Mapping]] = ..., revision: _Optional[int] = ..., sha256: _Optional[str] = ..., defaults: _Optional[_Union[Parameters, _Mapping]] = ..., parameters_json: _Optional[str] = ...) -> None: ...

class VehicleDescription(_message.Message):
    __slots__ = ("stamp", "vehicle_id", "vehicle_name", "vehicle_toml", "sha256", "software_version", "control_period_s", "actuator_names", "session_id")
    STAMP_FIELD_NUMBER: _ClassVar[int]
    VEHICLE_ID_FIELD_NUMBER: _ClassVar[int]
    VEHICLE_NAME_FIELD_NUMBER: _ClassVar[int]
    VEHICLE_TOML_FIELD_NUMBER: _ClassVar[int]
    SHA256_FIELD_NUMBER: _ClassVar[int]
    SOFTWARE_VERSION_FIELD_NUMBER: _ClassVar[int]
    CONTROL_PERIOD_S_FIELD_NUMBER: _ClassVar[int]
    ACTUATOR_NAMES_FIELD_NUMBER: _ClassVar[int]
    SESSION_ID_FIELD_NUMBER: _ClassVar[int]
    stamp: Stamp
    vehicle_id: str
    vehicle_name: str
    vehicle_toml: str
    sha256: str
    software_version: str
    control_period_s: float
    actuator_names: _containers.RepeatedScalarFieldContainer[str]
    session_id: str
    def __init__(self, stamp: _Optional[_Union[Stamp, _Mapping]] = ..., vehicle_id: _Optional[str] = ..., vehicle_name: _Optional[str] = ..., vehicle_toml: _Optional[str] = ..., sha256: _Optional[str] = ..., software_version: _Optional[str] = ..., control_period_s: _Optional[float] = ..., actuator_names: _Optional[_Iterable[str]] = ..., session_id: _Optional[str] = ...) -> None: ...

class Health(_message.Message):
    __slots__ = ("stamp", "cycles", "missed_cycles", "lateness_p99_ms", "lateness_max_ms", "cycle_time_p50_us", "cycle_time_p99_us", "resident_bytes", "process_id", "host_name", "dropped_rows", "leak", "battery_share")
    STAMP_FIELD_NUMBER: _ClassVar[int]
    CYCLES_FIELD_NUMBER: _ClassVar[int]
    MISSED_CYCLES_FIELD_NUMBER: _ClassVar[int]
    LATENESS_P99_MS_FIELD_NUMBER: _ClassVar[int]
    LATENESS_MAX_MS_FIELD_NUMBER: _ClassVar[int]
    CYCLE_TIME_P50_US_FIELD_NUMBER: _ClassVar[int]
    CYCLE_TIME_P99_US_FIELD_NUMBER: _ClassVar[int]
    RESIDENT_BYTES_FIELD_NUMBER: _ClassVar[int]
    PROCESS_ID_FIELD_NUMBER: _ClassVar[int]
    HOST_NAME_FIELD_NUMBER: _ClassVar[int]
    DROPPED_ROWS_FIELD_NUMBER: _ClassVar[int]
    LEAK_FIELD_NUMBER: _ClassVar[int]
    BATTERY_SHARE_FIELD_NUMBER: _ClassVar[int]
    stamp: Stamp
    cycles: int
    missed_cycles: int
    lateness_p99_ms: float
    lateness_max_ms: float
    cycle_time_p50_us: float
    cycle_time_p99_us: float
    resident_bytes: int
    process_id: int
    host_name: str
    dropped_rows: int
    leak: bool
    battery_share: float
    def __init__(self, stamp: _Optional[_Union[Stamp, _Mapping]] = ..., cycles: _Optional[int] = ..., missed_cycles: _Optional[int] = ..., lateness_p99_ms: _Optional[float] = ..., lateness_max_ms: _Optional[float] = ..., cycle_time_p50_us: _Optional[float] = ..., cycle_time_p99_us: _Optional[float] = ..., resident_bytes: _Optional[int] = ..., process_id: _Optional[int] = ..., host_name: _Optional[str] = ..., dropped_rows: _Optional[int] = ..., leak: _Optional[bool] = ..., battery_share: _Optional[float] = ...) -> None: ...

class Event(_message.Message):
    __slots__ = ("stamp", "severity", "code", "text", "details")
    class DetailsEntry(_message.Message):
        __slots__ = ("key", "value")
        KEY_FIELD_NUMBER: _ClassVar[int]
        VALUE_FIELD_NUMBER: _ClassVar[int]
        key: str
        value: str
        def __init__(self, key: _Optional[str] = ..., value: _Optional[str] = ...) -> None: ...
    STAMP_FIELD_NUMBER: _ClassVar[int]
    SEVERITY_FIELD_NUMBER: _ClassVar[int]
    CODE_FIELD_NUMBER: _ClassVar[int]
    TEXT_FIELD_NUMBER: _ClassVar[int]
    DETAILS_FIELD_NUMBER: _ClassVar[int]
    stamp: Stamp
    severity: Severity
    code: str
    text: str
    details: _containers.ScalarMap[str, str]
    def __init__(self, stamp: _Optional[_Union[Stamp, _Mapping]] = ..., severity: _Optional[_Union[Severity, str]] = ..., code: _Optional[str] = ..., text: _Optional[str] = ..., details: _Optional[_Mapping[str, str]] = ...) -> None: ...

class TruthState(_message.Message):
    __slots__ = ("stamp", "position_ned_m", "attitude", "velocity_body_mps", "angular_rate_body_degps", "actuator_wrench", "current_ned_mps", "effectiveness", "target_position_ned_m", "contact_force_n", "contact_force_most_n", "nose_depth_m", "nose_offset_m")
    STAMP_FIELD_NUMBER: _ClassVar[int]
    POSITION_NED_M_FIELD_NUMBER: _ClassVar[int]
    ATTITUDE_FIELD_NUMBER: _ClassVar[int]
    VELOCITY_BODY_MPS_FIELD_NUMBER: _ClassVar[int]
    ANGULAR_RATE_BODY_DEGPS_FIELD_NUMBER: _ClassVar[int]
    ACTUATOR_WRENCH_FIELD_NUMBER: _ClassVar[int]
    CURRENT_NED_MPS_FIELD_NUMBER: _ClassVar[int]
    EFFECTIVENESS_FIELD_NUMBER: _ClassVar[int]
    TARGET_POSITION_NED_M_FIELD_NUMBER: _ClassVar[int]
    CONTACT_FORCE_N_FIELD_NUMBER: _ClassVar[int]
    CONTACT_FORCE_MOST_N_FIELD_NUMBER: _ClassVar[int]
    NOSE_DEPTH_M_FIELD_NUMBER: _ClassVar[int]
    NOSE_OFFSET_M_FIELD_NUMBER: _ClassVar[int]
    stamp: Stamp
    position_ned_m: Vector3
    attitude: Attitude
    velocity_body_mps: Vector3
    angular_rate_body_degps: Vector3
    actuator_wrench: Wrench
    current_ned_mps: Vector3
    effectiveness: _containers.RepeatedScalarFieldContainer[float]
    target_position_ned_m: Vector3
    contact_force_n: float
    contact_force_most_n: float
    nose_depth_m: float
    nose_offset_m: float
    def __init__(self, stamp: _Optional[_Union[Stamp, _Mapping]] = ..., position_ned_m: _Optional[_Union[Vector3, _Mapping]] = ..., attitude: _Optional[_Union[Attitude, _Mapping]] = ..., velocity_body_mps: _Optional[_Union[Vector3, _Mapping]] = ..., angular_rate_body_degps: _Optional[_Union[Vector3, _Mapping]] = ..., actuator_wrench: _Optional[_Union[Wrench, _Mapping]] = ..., current_ned_mps: _Optional[_Union[Vector3, _Mapping]] = ..., effectiveness: _Optional[_Iterable[float]] = ..., target_position_ned_m: _Optional[_Union[Vector3, _Mapping]] = ..., contact_force_n: _Optional[float] = ..., contact_force_most_n: _Optional[float] = ..., nose_depth_m: _Optional[float] = ..., nose_offset_m: _Optional[float] = ...) -> None: ...

class StartMission(_message.Message):
    __slots__ = ("file_name", "mission_yaml", "seed", "operator")
    FILE_NAME_FIELD_NUMBER: _ClassVar[int]
    MISSION_YAML_FIELD_NUMBER: _ClassVar[int]
    SEED_FIELD_NUMBER: _ClassVar[int]
    OPERATOR_FIELD_NUMBER: _ClassVar[int]
    file_name: str
    mission_yaml: str
    seed: int
    operator: str
    def __init__(self, file_name: _Optional[str] = ..., mission_yaml: _Optional[str] = ..., seed: _Optional[int] = ..., operator: _Optional[str] = ...) -> None: ...

class RequestHeader(_message.Message):
    __slots__ = ("id", "expires_ns", "session_id", "author", "if_revision")
    ID_FIELD_NUMBER: _ClassVar[int]
    EXPIRES_NS_FIELD_NUMBER: _ClassVar[int]
    SESSION_ID_FIELD_NUMBER: _ClassVar[int]
    AUTHOR_FIELD_NUMBER: _ClassVar[int]
    IF_REVISION_FIELD_NUMBER: _ClassVar[int]
    id: str
    expires_ns: int
    session_id: str
    author: str
    if_revision: int
    def __init__(self, id: _Optional[str] = ..., expires_ns: _Optional[int] = ..., session_id: _Optional[str] = ..., author: _Optional[str] = ..., if_revision: _Optional[int] = ...) -> None: ...

class Empty(_message.Message):
    __slots__ = ()
    def __init__(self) -> None: ...

class CommandReply(_message.Message):
    __slots__ = ("accepted", "reason", "problems", "run_id", "revision", "id", "cause")
    ACCEPTED_FIELD_NUMBER: _ClassVar[int]
    REASON_FIELD_NUMBER: _ClassVar[int]
    PROBLEMS_FIELD_NUMBER: _ClassVar[int]
    RUN_ID_FIELD_NUMBER: _ClassVar[int]
    REVISION_FIELD_NUMBER: _ClassVar[int]
    ID_FIELD_NUMBER: _ClassVar[int]
    CAUSE_FIELD_NUMBER: _ClassVar[int]
    accepted: bool
    reason: str
    problems: _containers.RepeatedCompositeFieldContainer[Problem]
    run_id: str
    revision: int
    id: str
    cause: RefusalCause
    def __init__(self, accepted: _Optional[bool] = ..., reason: _Optional[str] = ..., problems: _Optional[_Iterable[_Union[Problem, _Mapping]]] = ..., run_id: _Optional[str] = ..., revision: _Optional[int] = ..., id: _Optional[str] = ..., cause: _Optional[_Union[RefusalCause, str]] = ...) -> None: ...

class Problem(_message.Message):
    __slots__ = ("file", "line", "column", "field", "value", "rule")
    FILE_FIELD_NUMBER: _ClassVar[int]
    LINE_FIELD_NUMBER: _ClassVar[int]
    COLUMN_FIELD_NUMBER: _ClassVar[int]
    FIELD_FIELD_NUMBER: _ClassVar[int]
    VALUE_FIELD_NUMBER: _ClassVar[int]
    RULE_FIELD_NUMBER: _ClassVar[int]
    file: str
    line: int
    column: int
    field: str
    value: str
    rule: str
    def __init__(self, file: _Optional[str] = ..., line: _Optional[int] = ..., column: _Optional[int] = ..., field: _Optional[str] = ..., value: _Optional[str] = ..., rule: _Optional[str] = ...) -> None: ...

class SwitchMetrics(_message.Message):
    __slots__ = ("from_mode", "to_mode", "time_s", "command_step_normalised", "command_step_raw", "actuator_step", "settling_s", "command_step_settling", "force_step_n", "moment_step_nm", "acceleration_step_mps2", "angular_acceleration_step_degps2")
    FROM_MODE_FIELD_NUMBER: _ClassVar[int]
    TO_MODE_FIELD_NUMBER: _ClassVar[int]
    TIME_S_FIELD_NUMBER: _ClassVar[int]
    COMMAND_STEP_NORMALISED_FIELD_NUMBER: _ClassVar[int]
    COMMAND_STEP_RAW_FIELD_NUMBER: _ClassVar[int]
    ACTUATOR_STEP_FIELD_NUMBER: _ClassVar[int]
    SETTLING_S_FIELD_NUMBER: _ClassVar[int]
    COMMAND_STEP_SETTLING_FIELD_NUMBER: _ClassVar[int]
    FORCE_STEP_N_FIELD_NUMBER: _ClassVar[int]
    MOMENT_STEP_NM_FIELD_NUMBER: _ClassVar[int]
    ACCELERATION_STEP_MPS2_FIELD_NUMBER: _ClassVar[int]
    ANGULAR_ACCELERATION_STEP_DEGPS2_FIELD_NUMBER: _ClassVar[int]
    from_mode: Mode
    to_mode: Mode
    time_s: float
    command_step_normalised: float
    command_step_raw: float
    actuator_step: _containers.RepeatedScalarFieldContainer[float]
    settling_s: float
    command_step_settling: float
    force_step_n: float
    moment_step_nm: float
    acceleration_step_mps2: float
    angular_acceleration_step_degps2: float
    def __init__(self, from_mode: _Optional[_Union[Mode, str]] = ..., to_mode: _Optional[_Union[Mode, str]] = ..., time_s: _Optional[float] = ..., command_step_normalised: _Optional[float] = ..., command_step_raw: _Optional[float] = ..., actuator_step: _Optional[_Iterable[float]] = ..., settling_s: _Optional[float] = ..., command_step_settling: _Optional[float] = ..., force_step_n: _Optional[float] = ..., moment_step_nm: _Optional[float] = ..., acceleration_step_mps2: _Optional[float] = ..., angular_acceleration_step_degps2: _Optional[float] = ...) -> None: ...

class ModeMetrics(_message.Message):
    __slots__ = ("mode", "duration_s", "samples", "depth_rms_m", "depth_peak_to_peak_m", "roll_rms_deg", "pitch_rms_deg", "yaw_rms_deg", "surge_speed_mean_mps", "actuator_rms", "residual_rms", "depth_error_rms_m", "depth_error_max_m", "cross_track_error_rms_m", "cross_track_error_max_m", "heading_error_rms_deg", "heading_error_max_deg", "speed_error_rms_mps", "speed_error_max_mps")
    MODE_FIELD_NUMBER: _ClassVar[int]
    DURATION_S_FIELD_NUMBER: _ClassVar[int]
    SAMPLES_FIELD_NUMBER: _ClassVar[int]
    DEPTH_RMS_M_FIELD_NUMBER: _ClassVar[int]
    DEPTH_PEAK_TO_PEAK_M_FIELD_NUMBER: _ClassVar[int]
    ROLL_RMS_DEG_FIELD_NUMBER: _ClassVar[int]
    PITCH_RMS_DEG_FIELD_NUMBER: _ClassVar[int]
    YAW_RMS_DEG_FIELD_NUMBER: _ClassVar[int]
    SURGE_SPEED_MEAN_MPS_FIELD_NUMBER: _ClassVar[int]
    ACTUATOR_RMS_FIELD_NUMBER: _ClassVar[int]
    RESIDUAL_RMS_FIELD_NUMBER: _ClassVar[int]
    DEPTH_ERROR_RMS_M_FIELD_NUMBER: _ClassVar[int]
    DEPTH_ERROR_MAX_M_FIELD_NUMBER: _ClassVar[int]
    CROSS_TRACK_ERROR_RMS_M_FIELD_NUMBER: _ClassVar[int]
    CROSS_TRACK_ERROR_MAX_M_FIELD_NUMBER: _ClassVar[int]
    HEADING_ERROR_RMS_DEG_FIELD_NUMBER: _ClassVar[int]
    HEADING_ERROR_MAX_DEG_FIELD_NUMBER: _ClassVar[int]
    SPEED_ERROR_RMS_MPS_FIELD_NUMBER: _ClassVar[int]
    SPEED_ERROR_MAX_MPS_FIELD_NUMBER: _ClassVar[int]
    mode: Mode
    duration_s: float
    samples: int
    depth_rms_m: float
    depth_peak_to_peak_m: float
    roll_rms_deg: float
    pitch_rms_deg: float
    yaw_rms_deg: float
    surge_speed_mean_mps: float
    actuator_rms: _containers.RepeatedScalarFieldContainer[float]
    residual_rms: float
    depth_error_rms_m: float
    depth_error_max_m: float
    cross_track_error_rms_m: float
    cross_track_error_max_m: float
    heading_error_rms_deg: float
    heading_error_max_deg: float
    speed_error_rms_mps: float
    speed_error_max_mps: float
    def __init__(self, mode: _Optional[_Union[Mode, str]] = ..., duration_s: _Optional[float] = ..., samples: _Optional[int] = ..., depth_rms_m: _Optional[float] = ..., depth_peak_to_peak_m: _Optional[float] = ..., roll_rms_deg: _Optional[float] = ..., pitch_rms_deg: _Optional[float] = ..., yaw_rms_deg: _Optional[float] = ..., surge_speed_mean_mps: _Optional[float] = ..., actuator_rms: _Optional[_Iterable[float]] = ..., residual_rms: _Optional[float] = ..., depth_error_rms_m: _Optional[float] = ..., depth_error_max_m: _Optional[float] = ..., cross_track_error_rms_m: _Optional[float] = ..., cross_track_error_max_m: _Optional[float] = ..., heading_error_rms_deg: _Optional[float] = ..., heading_error_max_deg: _Optional[float] = ..., speed_error_rms_mps: _Optional[float] = ..., speed_error_max_mps: _Optional[float] = ...) -> None: ...

class EndErrors(_message.Message):
    __slots__ = ("position_m", "horizontal_m", "depth_m", "heading_deg", "speed_mps")
    POSITION_M_FIELD_NUMBER: _ClassVar[int]
    HORIZONTAL_M_FIELD_NUMBER: _ClassVar[int]
    DEPTH_M_FIELD_NUMBER: _ClassVar[int]
    HEADING_DEG_FIELD_NUMBER: _ClassVar[int]
    SPEED_MPS_FIELD_NUMBER: _ClassVar[int]
    position_m: float
    horizontal_m: float
    depth_m: float
    heading_deg: float
    speed_mps: float
    def __init__(self, position_m: _Optional[float] = ..., horizontal_m: _Optional[float] = ..., depth_m: _Optional[float] = ..., heading_deg: _Optional[float] = ..., speed_mps: _Optional[float] = ...) -> None: ...

class Outcome(_message.Message):
    __slots__ = ("ending", "reason", "basis", "mode", "held_s", "closest_m", "closest_s", "true_errors", "believed_errors", "tries")
    ENDING_FIELD_NUMBER: _ClassVar[int]
    REASON_FIELD_NUMBER: _ClassVar[int]
    BASIS_FIELD_NUMBER: _ClassVar[int]
    MODE_FIELD_NUMBER: _ClassVar[int]
    HELD_S_FIELD_NUMBER: _ClassVar[int]
    CLOSEST_M_FIELD_NUMBER: _ClassVar[int]
    CLOSEST_S_FIELD_NUMBER: _ClassVar[int]
    TRUE_ERRORS_FIELD_NUMBER: _ClassVar[int]
    BELIEVED_ERRORS_FIELD_NUMBER: _ClassVar[int]
    TRIES_FIELD_NUMBER: _ClassVar[int]
    ending: Ending
    reason: str
    basis: str
    mode: Mode
    held_s: float
    closest_m: float
    closest_s: float
    true_errors: EndErrors
    believed_errors: EndErrors
    tries: int
    def __init__(self, ending: _Optional[_Union[Ending, str]] = ..., reason: _Optional[str] = ..., basis: _Optional[str] = ..., mode: _Optional[_Union[Mode, str]] = ..., held_s: _Optional[float] = ..., closest_m: _Optional[float] = ..., closest_s: _Optional[float] = ..., true_errors: _Optional[_Union[EndErrors, _Mapping]] = ..., believed_errors: _Optional[_Union[EndErrors, _Mapping]] = ..., tries: _Optional[int] = ...) -> None: ...

class CaptureMetrics(_message.Message):
    __slots__ = ("captured", "time_s", "seat_time_s", "force_max_n", "force_most_n", "entry_offset_m")
    CAPTURED_FIELD_NUMBER: _ClassVar[int]
    TIME_S_FIELD_NUMBER: _ClassVar[int]
    SEAT_TIME_S_FIELD_NUMBER: _ClassVar[int]
    FORCE_MAX_N_FIELD_NUMBER: _ClassVar[int]
    FORCE_MOST_N_FIELD_NUMBER: _ClassVar[int]
    ENTRY_OFFSET_M_FIELD_NUMBER: _ClassVar[int]
    captured: bool
    time_s: float
    seat_time_s: float
    force_max_n: float
    force_most_n: float
    entry_offset_m: float
    def __init__(self, captured: _Optional[bool] = ..., time_s: _Optional[float] = ..., seat_time_s: _Optional[float] = ..., force_max_n: _Optional[float] = ..., force_most_n: _Optional[float] = ..., entry_offset_m: _Optional[float] = ...) -> None: ...

class Metrics(_message.Message):
    __slots__ = ("run_id", "duration_s", "cycles", "residual_rms", "saturation_ratio", "d_u_fr", "d_u_rh", "switches", "modes", "solve_time_mean_us", "solve_time_std_us", "solve_time_p95_us", "solve_time_max_us", "final_range_m", "increment_violations", "demand_step_violations", "residual_rms_true", "missing_cycles", "solved_ratio", "outcome", "d_u_fr_settling", "d_u_rh_settling", "shaft_energy_j", "fin_travel_deg", "screw_reversals", "capture")
    RUN_ID_FIELD_NUMBER: _ClassVar[int]
    DURATION_S_FIELD_NUMBER: _ClassVar[int]
    CYCLES_FIELD_NUMBER: _ClassVar[int]
    RESIDUAL_RMS_FIELD_NUMBER: _ClassVar[int]
    SATURATION_RATIO_FIELD_NUMBER: _ClassVar[int]
    D_U_FR_FIELD_NUMBER: _ClassVar[int]
    D_U_RH_FIELD_NUMBER: _ClassVar[int]
    SWITCHES_FIELD_NUMBER: _ClassVar[int]
    MODES_FIELD_NUMBER: _ClassVar[int]
    SOLVE_TIME_MEAN_US_FIELD_NUMBER: _ClassVar[int]
    SOLVE_TIME_STD_US_FIELD_NUMBER: _ClassVar[int]
    SOLVE_TIME_P95_US_FIELD_NUMBER: _ClassVar[int]
    SOLVE_TIME_MAX_US_FIELD_NUMBER: _ClassVar[int]
    FINAL_RANGE_M_FIELD_NUMBER: _ClassVar[int]
    INCREMENT_VIOLATIONS_FIELD_NUMBER: _ClassVar[int]
    DEMAND_STEP_VIOLATIONS_FIELD_NUMBER: _ClassVar[int]
    RESIDUAL_RMS_TRUE_FIELD_NUMBER: _ClassVar[int]
    MISSING_CYCLES_FIELD_NUMBER: _ClassVar[int]
    SOLVED_RATIO_FIELD_NUMBER: _ClassVar[int]
    OUTCOME_FIELD_NUMBER: _ClassVar[int]
    D_U_FR_SETTLING_FIELD_NUMBER: _ClassVar[int]
    D_U_RH_SETTLING_FIELD_NUMBER: _ClassVar[int]
    SHAFT_ENERGY_J_FIELD_NUMBER: _ClassVar[int]
    FIN_TRAVEL_DEG_FIELD_NUMBER: _ClassVar[int]
    SCREW_REVERSALS_FIELD_NUMBER: _ClassVar[int]
    CAPTURE_FIELD_NUMBER: _ClassVar[int]
    run_id: str
    duration_s: float
    cycles: int
    residual_rms: float
    saturation_ratio: float
    d_u_fr: float
    d_u_rh: float
    switches: _containers.RepeatedCompositeFieldContainer[SwitchMetrics]
    modes: _containers.RepeatedCompositeFieldContainer[ModeMetrics]
    solve_time_mean_us: float
    solve_time_std_us: float
    solve_time_p95_us: float
    solve_time_max_us: float
    final_range_m: float
    increment_violations: int
    demand_step_violations: int
    residual_rms_true: float
    missing_cycles: int
    solved_ratio: float
    outcome: Outcome
    d_u_fr_settling: float
    d_u_rh_settling: float
    shaft_energy_j: float
    fin_travel_deg: float
    screw_reversals: int
    capture: CaptureMetrics
    def __init__(self, run_id: _Optional[str] = ..., duration_s: _Optional[float] = ..., cycles: _Optional[int] = ..., residual_rms: _Optional[float] = ..., saturation_ratio: _Optional[float] = ..., d_u_fr: _Optional[float] = ..., d_u_rh: _Optional[float] = ..., switches: _Optional[_Iterable[_Union[SwitchMetrics, _Mapping]]] = ..., modes: _Optional[_Iterable[_Union[ModeMetrics, _Mapping]]] = ..., solve_time_mean_us: _Optional[float] = ..., solve_time_std_us: _Optional[float] = ..., solve_time_p95_us: _Optional[float] = ..., solve_time_max_us: _Optional[float] = ..., final_range_m: _Optional[float] = ..., increment_violations: _Optional[int] = ..., demand_step_violations: _Optional[int] = ..., residual_rms_true: _Optional[float] = ..., missing_cycles: _Optional[int] = ..., solved_ratio: _Optional[float] = ..., outcome: _Optional[_Union[Outcome, _Mapping]] = ..., d_u_fr_settling: _Optional[float] = ..., d_u_rh_settling: _Optional[float] = ..., shaft_energy_j: _Optional[float] = ..., fin_travel_deg: _Optional[float] = ..., screw_reversals: _Optional[int] = ..., capture: _Optional[_Union[CaptureMetrics, _Mapping]] = ...) -> None: ...

class StreamMessage(_message.Message):
    __slots__ = ("topic", "schema", "payload", "receive_time_ns")
    TOPIC_FIELD_NUMBER: _ClassVar[int]
    SCHEMA_FIELD_NUMBER: _ClassVar[int]
    PAYLOAD_FIELD_NUMBER: _ClassVar[int]
    RECEIVE_TIME_NS_FIELD_NUMBER: _ClassVar[int]
    topic: str
    schema: str
    payload: bytes
    receive_time_ns: int
    def __init__(self, topic: _Optional[str] = ..., schema: _Optional[str] = ..., payload: _Optional[bytes] = ..., receive_time_ns: _Optional[int] = ...) -> None: ...

class StreamFrame(_message.Message):
    __slots__ = ("server_time_ns", "messages", "past")
    SERVER_TIME_NS_FIELD_NUMBER: _ClassVar[int]
    MESSAGES_FIELD_NUMBER: _ClassVar[int]
    PAST_FIELD_NUMBER: _ClassVar[int]
    server_time_ns: int
    messages: _containers.RepeatedCompositeFieldContainer[StreamMessage]
    past: bool
    def __init__(self, server_time_ns: _Optional[int] = ..., messages: _Optional[_Iterable[_Union[StreamMessage, _Mapping]]] = ..., past: _Optional[bool] = ...) -> None: ...

class Alarm(_message.Message):
    __slots__ = ("id", "code", "severity", "text", "raised_ns", "returned_ns", "acknowledged_ns", "acknowledged_by", "count", "shelved_until_ns", "details", "priority")
    class DetailsEntry(_message.Message):
        __slots__ = ("key", "value")
        KEY_FIELD_NUMBER: _ClassVar[int]
        VALUE_FIELD_NUMBER: _ClassVar[int]
        key: str
        value: str
        def __init__(self, key: _Optional[str] = ..., value: _Optional[str] = ...) -> None: ...
    ID_FIELD_NUMBER: _ClassVar[int]
    CODE_FIELD_NUMBER: _ClassVar[int]
    SEVERITY_FIELD_NUMBER: _ClassVar[int]
    TEXT_FIELD_NUMBER: _ClassVar[int]
    RAISED_NS_FIELD_NUMBER: _ClassVar[int]
    RETURNED_NS_FIELD_NUMBER: _ClassVar[int]
    ACKNOWLEDGED_NS_FIELD_NUMBER: _ClassVar[int]
    ACKNOWLEDGED_BY_FIELD_NUMBER: _ClassVar[int]
    COUNT_FIELD_NUMBER: _ClassVar[int]
    SHELVED_UNTIL_NS_FIELD_NUMBER: _ClassVar[int]
    DETAILS_FIELD_NUMBER: _ClassVar[int]
    PRIORITY_FIELD_NUMBER: _ClassVar[int]
    id: str
    code: str
    severity: Severity
    text: str
    raised_ns: int
    returned_ns: int
    acknowledged_ns: int
    acknowledged_by: str
    count: int
    shelved_until_ns: int
    details: _containers.ScalarMap[str, str]
    priority: int
    def __init__(self, id: _Optional[str] = ..., code: _Optional[str] = ..., severity: _Optional[_Union[Severity, str]] = ..., text: _Optional[str] = ..., raised_ns: _Optional[int] = ..., returned_ns: _Optional[int] = ..., acknowledged_ns: _Optional[int] = ..., acknowledged_by: _Optional[str] = ..., count: _Optional[int] = ..., shelved_until_ns: _Optional[int] = ..., details: _Optional[_Mapping[str, str]] = ..., priority: _Optional[int] = ...) -> None: ...

class Alarms(_message.Message):
    __slots__ = ("alarms",)
    ALARMS_FIELD_NUMBER: _ClassVar[int]
    alarms: _containers.RepeatedCompositeFieldContainer[Alarm]
    def __init__(self, alarms: _Optional[_Iterable[_Union[Alarm, _Mapping]]] = ...) -> None: ...

class AuditEntry(_message.Message):
    __slots__ = ("time_ns", "id", "verb", "author", "address", "details_json", "answer", "said", "took_s")
    TIME_NS_FIELD_NUMBER: _ClassVar[int]
    ID_FIELD_NUMBER: _ClassVar[int]
    VERB_FIELD_NUMBER: _ClassVar[int]
    AUTHOR_FIELD_NUMBER: _ClassVar[int]
    ADDRESS_FIELD_NUMBER: _ClassVar[int]
    DETAILS_JSON_FIELD_NUMBER: _ClassVar[int]
    ANSWER_FIELD_NUMBER: _ClassVar[int]
    SAID_FIELD_NUMBER: _ClassVar[int]
    TOOK_S_FIELD_NUMBER: _ClassVar[int]
    time_ns: int
    id: str
    verb: str
    author: str
    address: str
    details_json: str
    answer: str
    said: str
    took_s: float
    def __init__(self, time_ns: _Optional[int] = ..., id: _Optional[str] = ..., verb: _Optional[str] = ..., author: _Optional[str] = ..., address: _Optional[str] = ..., details_json: _Optional[str] = ..., answer: _Optional[str] = ..., said: _Optional[str] = ..., took_s: _Optional[float] = ...) -> None: ...

class ControlRequest(_message.Message):
    __slots__ = ("client", "name", "since_ns", "reason")
    CLIENT_FIELD_NUMBER: _ClassVar[int]
    NAME_FIELD_NUMBER: _ClassVar[int]
    SINCE_NS_FIELD_NUMBER: _ClassVar[int]
    REASON_FIELD_NUMBER: _ClassVar[int]
    client: str
    name: str
    since_ns: int
    reason: str
    def __init__(self, client: _Optional[str] = ..., name: _Optional[str] = ..., since_ns: _Optional[int] = ..., reason: _Optional[str] = ...) -> None: ...

class ControlHolder(_message.Message):
    __slots__ = ("holder", "holder_name", "since_ns", "until_ns", "reason", "requests")
    HOLDER_FIELD_NUMBER: _ClassVar[int]
    HOLDER_NAME_FIELD_NUMBER: _ClassVar[int]
    SINCE_NS_FIELD_NUMBER: _ClassVar[int]
    UNTIL_NS_FIELD_NUMBER: _ClassVar[int]
    REASON_FIELD_NUMBER: _ClassVar[int]
    REQUESTS_FIELD_NUMBER: _ClassVar[int]
    holder: str
    holder_name: str
    since_ns: int
    until_ns: int
    reason: str
    requests: _containers.RepeatedCompositeFieldContainer[ControlRequest]
    def __init__(self, holder: _Optional[str] = ..., holder_name: _Optional[str] = ..., since_ns: _Optional[int] = ..., until_ns: _Optional[int] = ..., reason: _Optional[str] = ..., requests: _Optional[_Iterable[_Union[ControlRequest, _Mapping]]] = ...) -> None: ...

class ServerStatus(_message.Message):
    __slots__ = ("time_ns", "vehicle_id", "link", "telemetry_age_s", "recording", "recording_run_id", "recorded_bytes", "recorder_dropped", "node_restarts", "stream_clients", "server_version", "node_managed", "recorder_trouble", "topics", "clock_offset_s", "bus_notice", "set_aside")
    TIME_NS_FIELD_NUMBER: _ClassVar[int]
    VEHICLE_ID_FIELD_NUMBER: _ClassVar[int]
    LINK_FIELD_NUMBER: _ClassVar[int]
    TELEMETRY_AGE_S_FIELD_NUMBER: _ClassVar[int]
    RECORDING_FIELD_NUMBER: _ClassVar[int]
    RECORDING_RUN_ID_FIELD_NUMBER: _ClassVar[int]
    RECORDED_BYTES_FIELD_NUMBER: _ClassVar[int]
    RECORDER_DROPPED_FIELD_NUMBER: _ClassVar[int]
    NODE_RESTARTS_FIELD_NUMBER: _ClassVar[int]
    STREAM_CLIENTS_FIELD_NUMBER: _ClassVar[int]
    SERVER_VERSION_FIELD_NUMBER: _ClassVar[int]
    NODE_MANAGED_FIELD_NUMBER: _ClassVar[int]
    RECORDER_TROUBLE_FIELD_NUMBER: _ClassVar[int]
    TOPICS_FIELD_NUMBER: _ClassVar[int]
    CLOCK_OFFSET_S_FIELD_NUMBER: _ClassVar[int]
    BUS_NOTICE_FIELD_NUMBER: _ClassVar[int]
    SET_ASIDE_FIELD_NUMBER: _ClassVar[int]
    time_ns: int
    vehicle_id: str
    link: LinkState
    telemetry_age_s: float
    recording: bool
    recording_run_id: str
    recorded_bytes: int
    recorder_dropped: int
    node_restarts: int
    stream_clients: int
    server_version: str
    node_managed: bool
    recorder_trouble: str
    topics: _containers.RepeatedCompositeFieldContainer[TopicFreshness]
    clock_offset_s: float
    bus_notice: str
    set_aside: int
    def __init__(self, time_ns: _Optional[int] = ..., vehicle_id: _Optional[str] = ..., link: _Optional[_Union[LinkState, str]] = ..., telemetry_age_s: _Optional[float] = ..., recording: _Optional[bool] = ..., recording_run_id: _Optional[str] = ..., recorded_bytes: _Optional[int] = ..., recorder_dropped: _Optional[int] = ..., node_restarts: _Optional[int] = ..., stream_clients: _Optional[int] = ..., server_version: _Optional[str] = ..., node_managed: _Optional[bool] = ..., recorder_trouble: _Optional[str] = ..., topics: _Optional[_Iterable[_Union[TopicFreshness, _Mapping]]] = ..., clock_offset_s: _Optional[float] = ..., bus_notice: _Optional[str] = ..., set_aside: _Optional[int] = ...) -> None: ...

class Heartbeat(_message.Message):
    __slots__ = ("time_ns", "session_id", "in_control")
    TIME_NS_FIELD_NUMBER: _ClassVar[int]
    SESSION_ID_FIELD_NUMBER: _ClassVar[int]
    IN_CONTROL_FIELD_NUMBER: _ClassVar[int]
    time_ns: int
    session_id: str
    in_control: bool
    def __init__(self, time_ns: _Optional[int] = ..., session_id: _Optional[str] = ..., in_control: _Optional[bool] = ...) -> None: ...

class TopicFreshness(_message.Message):
    __slots__ = ("topic", "age_s", "fresh_for_s", "late")
    TOPIC_FIELD_NUMBER: _ClassVar[int]
    AGE_S_FIELD_NUMBER: _ClassVar[int]
    FRESH_FOR_S_FIELD_NUMBER: _ClassVar[int]
    LATE_FIELD_NUMBER: _ClassVar[int]
    topic: str
    age_s: float
    fresh_for_s: float
    late: bool
    def __init__(self, topic: _Optional[str] = ..., age_s: _Optional[float] = ..., fresh_for_s: _Optional[float] = ..., late: _Optional[bool] = ...) -> None: ...

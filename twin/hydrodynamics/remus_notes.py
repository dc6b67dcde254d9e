"""Why some coefficients differ from the thesis by more than a few percent when its own geometry is used.

Each note can be checked with the numbers printed in the thesis; tests/hydrodynamics does so for most.
"""

_FIRST_MOMENT = (
    "first moment of added mass: +0.2 kg m of the bare hull less 2.3 of the fins; 4 mm of fin height or 5 mm "
    "of O_b make the difference"
)
_PLANFORM = (
    "moment of the side view about O_b, a small difference of fore and aft: the thesis' profile has its "
    "centre 16 mm behind O_b and its fins 0.64 m behind, so drag in heave pitches the nose down (M_ww < 0); "
    "the printed sign asks for a centre ahead of O_b"
)
_ROTATION = (
    "not geometry: even with all its side area at the far end the hull gives no more than 49 N m s^2; "
    "the printed values are 10 and 20 times 9.4"
)
_FIN = "the printed slope 3.12 and area give 10.7 N per rad; the printed coefficient is 0.90 of it"
_FIN_ARM = "fin term, as in Y_uudr, plus the exact added-mass term"
_LIFT = (
    "body lift 22.5 with the printed c_ydb = 1.2 plus fins 10.7; the printed sum less the printed fin term "
    "leaves c_ydb = 1.0"
)
_MUNK = "Munk 35.2 less body lift 7.2 less fins 6.8; follows from the notes on Y_uv and Y_uudr"

NOTES: dict[str, str] = {
    **dict.fromkeys(
        ("X_qq", "X_rr", "Y_rdot", "Y_pq", "Z_qdot", "Z_rp", "M_wdot", "M_vp", "N_vdot", "N_wp"),
        _FIRST_MOMENT,
    ),
    **dict.fromkeys(("Y_rr", "Z_qq", "M_ww", "N_vv"), _PLANFORM),
    **dict.fromkeys(("M_qq", "N_rr"), _ROTATION),
    **dict.fromkeys(("Y_uudr", "Z_uuds", "M_uuds", "N_uudr"), _FIN),
    **dict.fromkeys(("Y_ur", "Z_uq", "M_uq", "N_ur"), _FIN_ARM),
    **dict.fromkeys(("Y_uv", "Z_uw"), _LIFT),
    **dict.fromkeys(("M_uw", "N_uv"), _MUNK),
    "K_pdot": "the printed value needs fin tips 0.195 m off the axis; hull radius and span give 0.137 m",
    "K_pp": "the printed value needs fins 0.26 m off the axis; hull radius and span give 0.094 m",
}

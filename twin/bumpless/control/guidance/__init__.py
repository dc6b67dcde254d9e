"""References u_d, v_d, z_d, phi_d, theta_d, psi_d from the path, the target and the mode: see `guide`."""

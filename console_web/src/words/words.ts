// The words and symbols of the console, each declared once: pop-overs, glossary and palette read them here.
// Loaded when the first is asked for.

export interface Word {
  /** As it stands on the screen. */
  symbol: string;
  name: string;
  unit?: string;
  meaning: string;
  /** As the paper or the code computes it. */
  formula?: string;
}

export const WORDS = {
  kappa: {
    symbol: "κ",
    name: "transition factor",
    meaning:
      "How far the blend into the present mode has come: 0 at the switch, 1 when only the new mode counts. Demand, weights and prices go from the old mode's to the new one's with it.",
    formula: "τ_d = κ τ_d⁺ + (1 − κ) τ_d⁻",
  },
  dwell: {
    symbol: "dwell",
    name: "dwell time",
    unit: "s",
    meaning: "How long a mode must still be stayed in before any switch is allowed. 0: allowed now.",
  },
  detection_raw: {
    symbol: "Raw",
    name: "raw detection",
    meaning: "The target was seen in the last camera frame. One frame proves little in either direction.",
  },
  detection: {
    symbol: "Filtered",
    name: "filtered detection",
    meaning:
      "What the supervisor uses: the target was seen in M of the last N camera frames, and for a hold time after that.",
    formula: "detected ⇔ Σ hits over N frames ≥ M, or within the hold",
  },
  range: {
    symbol: "Range",
    name: "range to the observation point",
    unit: "m",
    meaning:
      "Distance from the vehicle to the point in front of the dock where it hovers. The supervisor's thresholds stand on it.",
  },
  thresholds: {
    symbol: "F→R, R→H …",
    name: "thresholds of the supervisor",
    unit: "m",
    meaning:
      "Ranges at which a mode is left. Each way has its own there and back, so that a noisy range does not switch twice.",
  },
  wrench: {
    symbol: "τ",
    name: "wrench (generalised force)",
    unit: "N, N·m",
    meaning:
      "Three forces and three moments about the body's origin: what the controller asks for, as one vector.",
    formula: "τ = [X Y Z K M N]",
  },
  X: { symbol: "X", name: "surge force", unit: "N", meaning: "Force along the body's forward axis." },
  Y: { symbol: "Y", name: "sway force", unit: "N", meaning: "Force to starboard." },
  Z: { symbol: "Z", name: "heave force", unit: "N", meaning: "Force downwards in body axes." },
  K: { symbol: "K", name: "roll moment", unit: "N·m", meaning: "Moment that presses starboard down." },
  M: { symbol: "M", name: "pitch moment", unit: "N·m", meaning: "Moment that lifts the bow." },
  N: { symbol: "N", name: "yaw moment", unit: "N·m", meaning: "Moment that turns the bow to starboard." },
  demanded: {
    symbol: "τ_d",
    name: "demanded wrench",
    unit: "N, N·m",
    meaning: "What the controller asks of the allocator in this cycle, after the ramp of a switch.",
  },
  achieved: {
    symbol: "τ_c",
    name: "achieved wrench",
    unit: "N, N·m",
    meaning: "What the chosen commands give by the allocator's own model of the actuators.",
    formula: "τ_c = G(u)",
  },
  residual: {
    symbol: "resid.",
    name: "residual wrench",
    unit: "N, N·m",
    meaning: "What was asked for and is not given. Marked where it is more than a tenth of the demand.",
    formula: "e_τ = τ_d − τ_c",
  },
  attainable: {
    symbol: "AFS, AMS",
    name: "attainable force and moment set",
    unit: "N, N·m",
    meaning:
      "All forces, and all moments, that the actuators together can give at the present speed through the water. A demand outside cannot be met by any allocator.",
    formula: "AFS = { Σ f_i(u_i) : u_i within its bounds }",
  },
  margin: {
    symbol: "margin",
    name: "margin",
    unit: "%",
    meaning:
      "How much of the attainable set the demand leaves, in its own direction; the smaller of force and moment. 100 % at rest, 0 % at the edge or beyond.",
    formula: "margin = 1 − max_d (d·τ_d / h(d))",
  },
  kkt: {
    symbol: "KKT",
    name: "KKT residual",
    meaning:
      "How far the allocator's answer is from the best one: the projected gradient, in commands over their bounds. Below 1e-6 it is solved.",
    formula: "‖P(u − ∇J(u)) − u‖",
  },
  residual_norm: {
    symbol: "‖e_τ‖_Q",
    name: "residual norm",
    meaning: "The residual wrench in one number, weighted as the mode weighs its components.",
    formula: "√(e_τᵀ Q e_τ)",
  },
  solve_time: {
    symbol: "solve time",
    name: "solve time",
    unit: "µs",
    meaning: "How long the allocator ran in this cycle, of a control period of 50 ms.",
  },
  sqp: {
    symbol: "SQP",
    name: "sequential quadratic programming",
    unit: "iterations",
    meaning:
      "How often the allocator linearised the actuators and solved the quadratic problem in this cycle.",
  },
  Q: {
    symbol: "Q",
    name: "weights of the wrench",
    unit: "1/N², 1/(N·m)²",
    meaning: "How much a missing newton or newton metre counts in each component, per mode.",
    formula: "J = e_τᵀ Q e_τ + uᵀ R u + λ …",
  },
  R: {
    symbol: "R",
    name: "prices of the commands",
    meaning: "How much each actuator's use costs, with its command over its bound, per mode.",
  },
  lambda: {
    symbol: "λ",
    name: "price of change",
    meaning: "How much a change of the commands from one cycle to the next costs, per mode.",
  },
  step: {
    symbol: "Δu",
    name: "step of the commands at a switch",
    meaning:
      "The largest change of all commands within one cycle around a switch, each over its bound. A bumpless switch keeps it small.",
    formula: "max ‖u_k − u_{k−1}‖ over the window",
  },
  at_bound: {
    symbol: "▲ at bound",
    name: "saturated",
    meaning: "The command stands at the actuator's amplitude bound: more of it is not to be had.",
  },
  rate_limited: {
    symbol: "◆ rate-limited",
    name: "rate-limited",
    meaning: "The command moves as fast as the actuator may per cycle, and would go further.",
  },
  cross_track: {
    symbol: "Cross-track",
    name: "cross-track error",
    unit: "m",
    meaning: "Distance from the leg's line, to starboard positive.",
  },
  ned: {
    symbol: "NED",
    name: "north, east, down",
    unit: "m",
    meaning: "The frame of positions: its origin is the mission's start, depth counts downwards.",
  },
  current: {
    symbol: "Current",
    name: "estimated current",
    unit: "m/s",
    meaning: "Speed of the water over ground as the vehicle estimates it.",
  },
  leg: {
    symbol: "Leg",
    name: "leg",
    meaning: 'Which stretch between two waypoints is flown, of how many. "back" after a missed approach.',
  },
  forward: { symbol: "F", name: "forward", meaning: "Cruise along the path: fins steer, the screw drives." },
  reverse: { symbol: "R", name: "reverse", meaning: "Brake and approach: fins fade out as the flow does." },
  hover: { symbol: "H", name: "hover", meaning: "Hold at the observation point with the thrusters." },
  wave_off: {
    symbol: "waved off",
    name: "wave-off",
    meaning:
      "An approach given up for a reason that is shown; the vehicle goes back along the line and tries again.",
  },
  shelved: {
    symbol: "shelved",
    name: "shelved alarm",
    meaning: "Known and put aside for a time by somebody; it comes back by itself if its cause still holds.",
  },
  stale: {
    symbol: "stale",
    name: "stale",
    meaning:
      "A last known value: nothing newer has come within the time the topic should take. Its age stands beside it.",
  },
  seed: {
    symbol: "Seed",
    name: "seed",
    meaning: "Of the simulated sensors and sea: the same seed flies the same flight to the bit.",
  },
} satisfies Record<string, Word>;

export type WordId = keyof typeof WORDS;

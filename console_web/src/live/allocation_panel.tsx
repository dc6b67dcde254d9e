// The allocator's own account of this cycle: status, optimality, residual, time.
import { useMemo } from "preact/hooks";
import { MissionPhase, SolveStatus } from "../gen/bumpless_pb";
import { compact, fixed } from "../lib/format";
import { colour } from "../lib/theme";
import { inForce, screen, shownPhase } from "../stream/screen";
import { Canvas } from "../ui/canvas";
import { AlarmIcon, CheckIcon, HollowIcon, WarningIcon } from "../ui/icons";
import { Empty, Panel } from "../ui/panel";
import { Term } from "../words/term";
import { pace } from "./pace";
import { shown } from "./time_axis";
import "./allocation_panel.css";

const STATUS: Record<SolveStatus, { name: string; look: string; about: string; Icon: typeof CheckIcon }> = {
  [SolveStatus.UNSPECIFIED]: { name: "Unknown", look: "off", about: "No status", Icon: WarningIcon },
  [SolveStatus.SOLVED]: {
    name: "Solved",
    look: "live",
    about: "KKT residual within tolerance",
    Icon: CheckIcon,
  },
  [SolveStatus.BUDGET_SPENT]: {
    name: "Budget spent",
    look: "stale",
    about: "Feasible; iterations used up before the tolerance",
    Icon: WarningIcon,
  },
  [SolveStatus.INFEASIBLE]: {
    name: "Infeasible",
    look: "lost",
    about: "Bounds contradict; nearest admissible command held",
    Icon: AlarmIcon,
  },
  [SolveStatus.FALLBACK]: {
    name: "Fallback",
    look: "stale",
    about: "The QP solver failed; the built-in active set answered",
    Icon: WarningIcon,
  },
  [SolveStatus.REFUSED]: {
    name: "Refused",
    look: "lost",
    about: "Demand not finite; last command held",
    Icon: AlarmIcon,
  },
};

export function AllocationPanel() {
  return (
    <Panel title="Allocation" topic="tlm/allocation" class="allocation-panel" aside={<Status />}>
      <Figures />
    </Panel>
  );
}

function Status() {
  const allocation = screen.latest("tlm/allocation");
  if (!allocation) return null;
  if (!inForce.value) {
    const aborted = shownPhase.value === MissionPhase.ABORTED;
    return (
      <span class="chip" data-look="off" title="Nothing is allocated: no control is in force">
        <HollowIcon size={11} /> {aborted ? "Stopped" : "Idle"}
      </span>
    );
  }
  const { name, look, about, Icon } = STATUS[allocation.status];
  const state = screen.isFresh("tlm/allocation") ? "fresh" : "stale";
  return (
    <span class="chip" data-look={look} data-state={state} title={about}>
      <Icon /> {name}
    </span>
  );
}

function Figures() {
  const a = screen.latest("tlm/allocation");
  if (a && !inForce.value) return <Empty>Nothing is allocated: no control is in force.</Empty>;
  if (!a) return <Empty>The allocator reports with the first telemetry.</Empty>;
  return (
    <div class="figures">
      <Figure
        word="kkt"
        name="KKT residual"
        value={compact(a.kktResidual, 2)}
        column=""
        about="Projected gradient, bound-normalised"
      />
      <Figure
        word="residual_norm"
        name="Residual norm"
        value={compact(a.residualNorm)}
        column="residual"
        about="||tau_d − tau_c|| weighted by Q"
      />
      <Figure
        word="solve_time"
        name="Solve time"
        value={fixed(a.solveTimeUs, 0)}
        unit="µs"
        column="solve_time"
        about="Allocator's run time in this cycle"
      />
      <Figure
        word="sqp"
        name="SQP"
        value={String(a.sqpIterations)}
        unit={`it. ${a.solver}`}
        column=""
        about={`Cost ${compact(a.cost)}; ${a.saturatedCount} at a bound; slack ${compact(a.slackNorm)}`}
      />
    </div>
  );
}

interface FigureProps {
  word: "kkt" | "residual_norm" | "solve_time" | "sqp";
  name: string;
  value: string;
  unit?: string;
  column: string;
  about: string;
}

function Figure({ word, name, value, unit, column, about }: FigureProps) {
  const due = useMemo(pace, []);
  return (
    <div class="figure" title={about}>
      <span class="muted">
        <Term of={word}>{name}</Term>
      </span>
      <span>
        <b class="num">{value}</b>
        {unit && <span class="unit"> {unit}</span>}
      </span>
      {column && (
        <Canvas
          class="spark"
          due={due}
          name={`${name} over time`}
          paint={(g, w, h) => spark(g, w, h, column)}
        />
      )}
    </div>
  );
}

function spark(g: CanvasRenderingContext2D, width: number, height: number, name: string): void {
  const column = screen.history.column(name);
  const [from, to] = shown();
  if (!column || !Number.isFinite(to)) return;
  const first = screen.history.firstIndex(from);
  const end = screen.history.firstIndex(to + 1e-6);
  let top = 0;
  for (let i = first; i < end; i++) top = Math.max(top, column[i] || 0);
  if (top <= 0) return;
  g.strokeStyle = colour("--trace");
  g.lineWidth = 1;
  g.beginPath();
  for (let i = first; i < end; i++) {
    const value = column[i] as number;
    if (Number.isNaN(value)) continue;
    const x = (((screen.history.time[i] as number) - from) / (to - from)) * width;
    g.lineTo(x, height - 1 - (value / top) * (height - 2));
  }
  g.stroke();
}

// Charts: which are drawn beneath the plan, which one is the sea floor, and how more come in.
import { useSignal } from "@preact/signals";
import { useRef } from "preact/hooks";
import { bytes } from "../../lib/format";
import { ActButton } from "../../ui/act_button";
import { TrashIcon } from "../../ui/icons";
import { RefusalIn } from "../../ui/refusal";
import { originOf } from "../model/earth";
import { name } from "../model/library";
import { edit, mission } from "../model/plan";
import {
  addChart,
  type ChartSummary,
  charts,
  chartsElsewhere,
  chartsHere,
  chartTrouble,
  floorChart,
  hidden,
  ownChart,
  removeChart,
  setHidden,
} from "./charts";
import "./charts.css";

const KINDS: Record<ChartSummary["kind"], string> = {
  features: "shapes",
  picture: "picture",
  depths: "depths",
};
const PICTURE = /\.(png|jpe?g|webp)$/i;
const CLEARANCE_M = 1;

export function ChartsPanel() {
  const list = chartsHere.value ?? [];
  const elsewhere = chartsElsewhere.value;
  return (
    <div class="form">
      <h3 class="form-title">Charts beneath the plan</h3>
      <RefusalIn title="That chart was not kept." of={chartTrouble} />
      {charts.refusal && <p class="lost">The charts can't be read: {charts.refusal.reason}</p>}
      {list.length === 0 && !charts.refusal && (
        <p class="hint">
          None yet. GeoJSON and KML are drawn, a GeoTIFF or ESRI ASCII grid gives depths, a picture lies on
          its four corners.
        </p>
      )}
      <ul class="charts">
        {list.map((chart) => (
          <Chart key={chart.name} chart={chart} />
        ))}
      </ul>
      {elsewhere.length > 0 && (
        <details class="field-block">
          <summary>
            Of other missions <span class="muted num">{elsewhere.length}</span>
          </summary>
          <ul class="charts">
            {elsewhere.map((chart) => (
              <li key={chart.name} class="chart-row">
                <span class="ellipsis grow" title={`Of ${chart.missions.join(", ")}`}>
                  {chart.title}
                </span>
                <button
                  type="button"
                  class="action small"
                  onClick={() => void ownChart(chart.name, [...chart.missions, name.peek()])}
                >
                  Here too
                </button>
              </li>
            ))}
          </ul>
        </details>
      )}
      <Add />
    </div>
  );
}

function Chart({ chart }: { chart: ChartSummary }) {
  const origin = originOf(mission.value.raw);
  const lost = chart.geographic && !origin;
  const floor = chart.kind === "depths" && chart.name === floorChart.value;
  const about = [chart.format, bytes(chart.size), ...chart.notes].join(", ");
  return (
    <li class="chart-row">
      <label title={lost ? `It needs an origin on the earth: set one in Details. ${about}` : about}>
        <input
          type="checkbox"
          aria-disabled={lost}
          title={lost ? "It lies on the earth, and the mission names no origin" : undefined}
          checked={!lost && !hidden.value.includes(chart.name)}
          onClick={(event) => lost && event.preventDefault()}
          onChange={(event) => setHidden(chart.name, !event.currentTarget.checked)}
        />
        <span class="ellipsis">{chart.title}</span>
        <span class="tag">{KINDS[chart.kind]}</span>
      </label>
      {chart.kind === "depths" && (
        <button
          type="button"
          class="action small"
          aria-pressed={floor}
          title="The check and the profile keep clear of it"
          onClick={() => edit(floor ? "No sea floor" : "Sea floor", floorEdits(chart.name, floor))}
        >
          Sea floor
        </button>
      )}
      <button
        type="button"
        class="action small"
        aria-pressed={chart.missions.length > 0}
        title={
          chart.missions.length > 0
            ? `It belongs to ${chart.missions.join(", ")}; press to show it in every mission`
            : "It belongs to the site and lies beneath every mission; press to keep it to this one"
        }
        onClick={() => void ownChart(chart.name, chart.missions.length > 0 ? [] : [name.peek()])}
      >
        This mission
      </button>
      <button
        type="button"
        class="quiet tiny"
        aria-label={`Delete the chart ${chart.title}`}
        onClick={() => void removeChart(chart.name)}
      >
        <TrashIcon />
      </button>
      {lost && <p class="hint">It lies on the earth: give the mission an origin to see it.</p>}
    </li>
  );
}

function floorEdits(name: string, off: boolean) {
  if (off) return [{ path: ["sea_floor"], value: undefined }];
  const { sea_floor } = (mission.peek().raw ?? {}) as { sea_floor?: unknown };
  return sea_floor && typeof sea_floor === "object"
    ? [{ path: ["sea_floor", "grid"], value: name }]
    : [{ path: ["sea_floor"], value: { grid: name, clearance_m: CLEARANCE_M } }];
}

function Add() {
  const box = useRef<HTMLInputElement>(null);
  const picture = useSignal<File | undefined>(undefined);
  const local = useSignal(false);
  const corners = useSignal("");
  const give = async (file: File): Promise<void> => {
    if (await addChart({ file, corners: corners.peek(), local: local.peek() })) picture.value = undefined;
  };
  const file = picture.value;
  return (
    <div class="field-block">
      <label class="field-row">
        <span class="field-label">Its numbers are metres of the mission's own frame</span>
        <input
          type="checkbox"
          checked={local.value}
          onChange={(event) => {
            local.value = event.currentTarget.checked;
          }}
        />
      </label>
      {file && (
        <label class="field-block">
          <span class="field-label">
            Corners of {file.name}: top left, top right, bottom right, bottom left, as{" "}
            {local.value ? "north,east" : "latitude,longitude"}
          </span>
          <input
            aria-label="Corners of the picture"
            placeholder={
              local.value ? "40,-10; 40,30; 0,30; 0,-10" : "54.41,10.2; 54.41,10.22; 54.4,10.22; 54.4,10.2"
            }
            value={corners.value}
            onInput={(event) => {
              corners.value = event.currentTarget.value;
            }}
          />
        </label>
      )}
      <div class="form-head">
        {file && (
          <ActButton
            class="action small primary"
            why={
              corners.value.split(";").length === 4 ? "" : "Give four corners first, with semicolons between"
            }
            onAct={() => void give(file)}
          >
            Lay it there
          </ActButton>
        )}
        <button
          type="button"
          class="action small"
          title="GeoJSON, KML, KMZ, GeoTIFF, ESRI ASCII grid, PNG, JPEG, WebP"
          onClick={() => box.current?.click()}
        >
          Add a chart …
        </button>
        <input
          ref={box}
          type="file"
          accept=".geojson,.json,.kml,.kmz,.tif,.tiff,.asc,.png,.jpg,.jpeg,.webp"
          class="sr"
          tabIndex={-1}
          aria-label="Chart file"
          onChange={(event) => {
            const [given] = event.currentTarget.files ?? [];
            event.currentTarget.value = "";
            if (!given) return;
            if (PICTURE.test(given.name)) picture.value = given;
            else void give(given);
          }}
        />
      </div>
    </div>
  );
}

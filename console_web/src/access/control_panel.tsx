// Who holds control, who asks for it, and what this browser can do about it.
import { useSignal } from "@preact/signals";
import { dateTime } from "../lib/format";
import { RefusalIn } from "../ui/refusal";
import {
  asked,
  askForControl,
  commands,
  control,
  controlRefused,
  declineControl,
  handControl,
  heldByOther,
  holds,
  releaseControl,
  takeControl,
} from "./control";
import "./control_panel.css";

export function ControlPanel() {
  const state = control.value;
  return (
    <div class="control-panel">
      <p role="status">
        <Holding />
        {state?.reason && <span class="muted"> Taken because: {state.reason}</span>}
      </p>
      {commands.value && <Actions />}
      {state && state.requests.length > 0 && (
        <ul aria-label="Requests for control">
          {state.requests.map((request) => (
            <li key={request.client}>
              <strong>{request.name}</strong> asks for control
              {request.reason && `: ${request.reason}`}
              {holds.value && (
                <>
                  <button
                    type="button"
                    class="action small primary"
                    aria-label={`Hand control to ${request.name}`}
                    onClick={() => void handControl(request.client)}
                  >
                    Hand over
                  </button>
                  <button
                    type="button"
                    class="action small"
                    aria-label={`Keep control from ${request.name}`}
                    onClick={() => void declineControl(request.client)}
                  >
                    Keep it
                  </button>
                </>
              )}
            </li>
          ))}
        </ul>
      )}
      <RefusalIn title="Control stays as it is." of={controlRefused} />
    </div>
  );
}

function Holding() {
  const state = control.value;
  if (!state?.holder) return <>Nobody holds control: the next command takes it.</>;
  const since = dateTime(new Date(Number(state.sinceNs / 1_000_000n)).toISOString());
  return (
    <>
      {holds.value ? "You hold control" : <strong>{state.holderName}</strong>}
      {!holds.value && " holds control"} since {since}.
      {state.untilNs > 0n && " Out of touch: it falls free in a few seconds."}
    </>
  );
}

function Actions() {
  const reason = useSignal("");
  if (holds.value) {
    return (
      <button type="button" class="action small" onClick={() => void releaseControl()}>
        Give control up
      </button>
    );
  }
  if (!heldByOther.value) {
    return (
      <button type="button" class="action small" onClick={() => void askForControl()}>
        Take free control
      </button>
    );
  }
  return (
    <form
      class="control-actions"
      aria-label="Take control"
      onSubmit={(event) => {
        event.preventDefault();
        void takeControl(reason.value);
      }}
    >
      {asked.value ? (
        <button type="button" class="action small" onClick={() => void releaseControl()}>
          Stop asking
        </button>
      ) : (
        <button type="button" class="action small" onClick={() => void askForControl()}>
          Ask for control
        </button>
      )}
      <input
        aria-label="Why control is taken"
        placeholder="Why: everybody reads it"
        required
        minLength={3}
        maxLength={200}
        value={reason.value}
        onInput={(event) => {
          reason.value = event.currentTarget.value;
        }}
      />
      <button type="submit" class="action small">
        Take control
      </button>
    </form>
  );
}

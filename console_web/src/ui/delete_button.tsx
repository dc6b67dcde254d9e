// Delete by pressing and holding; what stands against it is shown beneath.
import { useSignal } from "@preact/signals";
import type { Answer, Refusal } from "../api/http";
import { HoldButton } from "./hold_button";
import { TrashIcon } from "./icons";
import { RefusalIn } from "./refusal";

interface Props {
  name: string;
  holdMs: number;
  /** Why it can't be deleted now; "" when it can. */
  why?: string;
  title?: string;
  remove: () => Promise<Answer<unknown>>;
  /** After the answer; `gone` says whether it was deleted. */
  after: (gone: boolean) => Promise<void>;
}

export function DeleteButton({ name, holdMs, why, title, remove, after }: Props) {
  const refusal = useSignal<Refusal | undefined>(undefined);
  const held = async (): Promise<void> => {
    const answer = await remove();
    refusal.value = answer.ok ? undefined : answer;
    await after(answer.ok);
  };
  return (
    <>
      <HoldButton
        name={name}
        class="danger"
        holdMs={holdMs}
        {...(why ? { why } : {})}
        title={title}
        onHeld={() => void held()}
      >
        <TrashIcon /> Hold to delete
      </HoldButton>
      <RefusalIn title="Not deleted." of={refusal} />
    </>
  );
}

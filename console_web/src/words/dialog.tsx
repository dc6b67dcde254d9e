// A sheet above the page: the rest waits, Escape or a press beside it closes it, the focus goes back.
import type { ComponentChildren } from "preact";
import { useLayoutEffect, useRef } from "preact/hooks";

interface Props {
  name: string;
  class: string;
  onClose: () => void;
  children: ComponentChildren;
}

export function Dialog({ name, class: look, onClose, children }: Props) {
  const box = useRef<HTMLDialogElement>(null);
  useLayoutEffect(() => {
    const [before, dialog] = [document.activeElement, box.current];
    dialog?.showModal();
    return () => {
      dialog?.close(); // while it is open all else is inert and takes no focus
      if (before instanceof HTMLElement && before.isConnected) before.focus();
    };
  }, []);
  return (
    // biome-ignore lint/a11y/useKeyWithClickEvents: Escape closes it, by the browser itself
    <dialog
      ref={box}
      class={`sheet ${look}`}
      aria-label={name}
      onClose={() => box.current?.isConnected && onClose()}
      onCancel={(event) => {
        event.preventDefault(); // at once: the browser's own close tells of it later than the next key
        onClose();
      }}
      onClick={(event) => event.target === box.current && onClose()}
    >
      {children}
    </dialog>
  );
}

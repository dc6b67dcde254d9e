// The button that deletes what is selected.
import { TrashIcon } from "../../ui/icons";
import { deleteSelected } from "../model/operations";

export function Remove({ what }: { what: string }) {
  return (
    <button type="button" class="action small" onClick={deleteSelected} title="Delete">
      <TrashIcon /> Delete {what}
    </button>
  );
}

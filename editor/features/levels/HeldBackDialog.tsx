import { useStore } from 'zustand';
import { useEditor } from '../../core/context/index.ts';
import { deleteLevel, openHeldBack, openListed } from '../../core/levels/index.ts';
import { Button, Dialog } from '../../core/ui/index.ts';

/**
 * Asks what to do with a level that was being opened when the page last stopped. Opening it again automatically could make the
 * editor unusable.
 */
export function HeldBackDialog() {
  const editor = useEditor();
  const { heldBack, workspace, marks } = editor;
  const id = useStore(heldBack);
  const list = useStore(workspace.store, (state) => state.list);
  const entry = list?.levels.find((level) => level.id === id);
  const other = list?.levels.find(({ id, status }) => status === 'valid' && !marks.has(`${list.folder.id}/${id}`));
  const close = () => heldBack.setState(null, true);
  const act = (what: () => Promise<void>) => () => {
    close();
    void what();
  };
  return (
    <Dialog
      open={id !== null && entry !== undefined}
      title="This level was not opened"
      about="The page was opening this level when it last stopped. Either the page was closed at that moment, or the level was too much work for it."
      onClose={close}
    >
      {id !== null && entry !== undefined && (
        <div className="form link">
          <p className="link__name">{entry.name ?? id}</p>
          <p className="link__text">{entry.file}</p>
          <div className="form__buttons">
            <Button hint="Move it to the deleted levels" look="outlined" onClick={act(() => deleteLevel(editor, entry))}>
              Delete
            </Button>
            {other !== undefined && (
              <Button hint={`Open ${other.name ?? other.id}`} look="outlined" onClick={act(() => openListed(editor, other.id))}>
                Open another level
              </Button>
            )}
            <Button hint="Open it like any other level" look="outlined" onClick={act(() => openHeldBack(editor, id, true))}>
              Open anyway
            </Button>
            <Button
              hint="Open it for editing only: it is not simulated and not searched"
              look="main"
              onClick={act(() => openHeldBack(editor, id, false))}
            >
              Open without checks
            </Button>
          </div>
        </div>
      )}
    </Dialog>
  );
}

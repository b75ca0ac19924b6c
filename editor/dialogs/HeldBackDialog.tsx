import { useStore } from 'zustand';
import { useEditor } from '../context/index.ts';
import { deleteLevel, openHeldBack, openListed } from '../panels/levels/index.ts';
import { Button, Dialog } from '../ui/index.ts';

/** Asks what is to become of a level whose opening the last page did not survive: opened by itself it would make the editor unusable for good. */
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
      about="The page was opening it when it last stopped: it was closed at that moment, or the level took more work than the page could do."
      onClose={close}
    >
      {id !== null && entry !== undefined && (
        <div className="form link">
          <p className="link__name">{entry.name ?? id}</p>
          <p className="link__text">{entry.file}</p>
          <div className="form__buttons">
            <Button hint="Move it to the deleted levels" look="outlined" onClick={act(() => deleteLevel(editor, entry))}>
              Delete it
            </Button>
            {other !== undefined && (
              <Button hint={`Open ${other.name ?? other.id}`} look="outlined" onClick={act(() => openListed(editor, other.id))}>
                Open another
              </Button>
            )}
            <Button hint="Open it as any other level" look="outlined" onClick={act(() => openHeldBack(editor, id, true))}>
              Open it all the same
            </Button>
            <Button
              hint="Open it to be edited: nothing is played and nothing is looked for"
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

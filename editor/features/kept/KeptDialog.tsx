import { Download, Trash2 } from 'lucide-react';
import { useEffect, useState } from 'react';
import { useStore } from 'zustand';
import { useEditor, useOverlay } from '../../core/context/index.ts';
import { keepFile, levelFile } from '../../core/exchange/index.ts';
import { openListed } from '../../core/levels/index.ts';
import { Button, Dialog } from '../../core/ui/index.ts';

/** Changes that never reached the disk but are kept in this browser: the user can open, download or discard them. */
export function KeptDialog() {
  const dialog = useOverlay('kept');
  return (
    <Dialog
      {...dialog}
      title="Unsaved changes"
      about={`Kept in this browser for ${location.host}. Other addresses and ports have their own.`}
    >
      <Kept onClose={dialog.onClose} />
    </Dialog>
  );
}

type KeptLevel = { readonly place: string; readonly time: number };

function Kept({ onClose }: { readonly onClose: () => void }) {
  const editor = useEditor();
  const { journal, workspace, notices } = editor;
  const list = useStore(workspace.store, (state) => state.list);
  const [places, setPlaces] = useState<readonly KeptLevel[] | 'failed' | null>(null);
  const [sure, setSure] = useState<string | null>(null);
  useEffect(() => {
    let isGone = false;
    journal.unsaved().then(
      (found) => !isGone && setPlaces(found),
      () => !isGone && setPlaces('failed'),
    );
    return () => {
      isGone = true;
    };
  }, [journal]);

  if (places === null) return <p>Loading…</p>;
  if (places === 'failed') return <p role="alert">This browser's database does not answer. Try again in a moment.</p>;
  if (places.length === 0) return <p className="trash__empty">Everything is saved.</p>;
  const download = async (place: string, id: string) => {
    const found = await journal.recover(place).catch(() => null);
    if (found === null) notices.show('warning', `The kept changes of ${id} can't be read.`);
    else await keepFile(levelFile(id, found.file));
  };
  const forget = async (place: string) => {
    if (sure !== place) {
      setSure(place);
      return;
    }
    await journal.forget(place).catch(() => undefined);
    setPlaces(places.filter((other) => other.place !== place));
  };
  return (
    <ul className="trash">
      {places.map(({ place, time }) => {
        const [folder, id] = [place.slice(0, place.indexOf('/')), place.slice(place.indexOf('/') + 1)];
        const isHere = list?.folder.id === folder && list.levels.some((level) => level.id === id);
        const isOpen = isHere && workspace.store.getState().opened?.id() === id;
        return (
          <li key={place} className="trash__entry">
            <span className="trash__name">
              {id}
              {isOpen
                ? ', open here'
                : !isHere && (list?.folder.id === folder ? ', no longer in this folder' : ', in another folder')}
            </span>
            <time className="trash__time" dateTime={new Date(time).toISOString()}>
              {new Date(time).toLocaleString()}
            </time>
            <Button
              hint={`Download ${id} with its unsaved changes`}
              look="outlined"
              icon={<Download size={14} />}
              onClick={() => void download(place, id)}
            >
              Download
            </Button>
            {isHere && !isOpen && (
              <Button
                hint={`Open ${id} with its changes restored as one step`}
                look="outlined"
                onClick={() => {
                  onClose();
                  void openListed(editor, id);
                }}
              >
                Open
              </Button>
            )}
            {!isOpen && (
              <Button
                hint="Discard the changes permanently"
                look="outlined"
                icon={<Trash2 size={14} />}
                onClick={() => void forget(place)}
              >
                {sure === place ? 'Discard permanently?' : undefined}
              </Button>
            )}
          </li>
        );
      })}
    </ul>
  );
}

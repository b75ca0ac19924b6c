import { Check, Eye, Gamepad2, Undo2 } from 'lucide-react';
import { type ComponentType, type ReactNode, useEffect, useId, useRef } from 'react';
import { useStore } from 'zustand';
import { useEditor } from '../context/index.ts';
import { addSamples } from '../levels/index.ts';
import { Button } from '../ui/index.ts';
import { laterDialog } from './later.tsx';
import './offers.css';
import type { TextDialogProps } from './TextDialog.tsx';

interface OfferProps {
  /** What would be changed, as a sentence. */
  readonly text: string;
  /** Its size, and what the run is like then. */
  readonly figures: ReactNode;
  readonly figuresTitle?: string;
  readonly isShown: boolean;
  /** null: it can't be shown any more */
  readonly onPreview: (() => void) | null;
  readonly onBack: () => void;
  readonly onTake: () => void;
}

/** A change that the page offers: it can be previewed, and then taken or not. An item of a list. */
export function Offer({ text, figures, figuresTitle, isShown, onPreview, onBack, onTake }: OfferProps) {
  const item = useRef<HTMLLIElement>(null);
  const wasShown = useRef(isShown);
  // the button that was pressed is gone: the next one takes its place
  useEffect(() => {
    const isFree = document.activeElement === document.body || item.current?.parentElement?.contains(document.activeElement);
    if (isShown !== wasShown.current && isFree) item.current?.querySelector<HTMLElement>('button:last-of-type')?.focus();
    wasShown.current = isShown;
  }, [isShown]);
  return (
    <li ref={item} className={isShown ? 'offer offer--previewed' : 'offer'}>
      <span className="offer__text">{text}</span>
      <div className="offer__row">
        <span className="part__note numbers" title={figuresTitle}>
          {figures}
        </span>
        {isShown ? (
          <span className="offer__does">
            <Button hint="Go back to the level as it is" icon={<Undo2 size={14} />} onClick={onBack}>
              Back
            </Button>
            <Button hint="Keep this change: one step of undo" icon={<Check size={14} />} look="outlined" onClick={onTake}>
              Take
            </Button>
          </span>
        ) : (
          onPreview !== null && (
            <Button
              hint="Show the level with this change; nothing is saved yet"
              hintSide="left"
              icon={<Eye size={14} />}
              look="outlined"
              onClick={onPreview}
            >
              Preview
            </Button>
          )
        )}
      </div>
    </li>
  );
}

/** The way out of a list that is empty because nobody has played the level. */
export function PlayButton() {
  const { commands } = useEditor();
  return (
    <Button
      hint="Play from the start"
      shortcut="Space"
      look="main"
      icon={<Gamepad2 size={15} />}
      onClick={() => commands.run('play.start')}
    >
      Play the level
    </Button>
  );
}

/** Offers the levels that come with the toolkit. */
export function SamplesButton() {
  const editor = useEditor();
  return (
    <Button
      hint="Levels that come with the toolkit, each with a run that completes it"
      look="outlined"
      onClick={() => void addSamples(editor, '')}
    >
      Add sample levels
    </Button>
  );
}

/** Selects the folder of a level; hidden if there is only one. */
export function FolderSelect({ value, onChange }: { readonly value: string; readonly onChange: (folder: string) => void }) {
  const { workspace } = useEditor();
  const list = useStore(workspace.store, (state) => state.list);
  const id = useId();
  if (list === null || list.folders.length < 2) return null;
  return (
    <>
      <label htmlFor={id}>Folder</label>
      <select id={id} className="field" value={value} onChange={(event) => onChange(event.target.value)}>
        {list.folders.map((folder) => (
          <option key={folder} value={folder}>
            {folder === '' ? list.folder.path : folder}
          </option>
        ))}
      </select>
    </>
  );
}

/** Edits a level as text. */
export const TextDialog: ComponentType<TextDialogProps> = laterDialog(() =>
  import('./TextDialog.tsx').then((there) => there.TextDialog),
);

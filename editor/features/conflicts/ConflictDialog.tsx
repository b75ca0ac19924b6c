import { useEffect, useMemo, useState } from 'react';
import { useStore } from 'zustand';
import { type Choices, type Conflict, conflictsOf, mergeLevels, resolveConflicts, type Side } from '../../../review/index.ts';
import { formatLevel, type LevelFile, type Problem } from '../../../schema/index.ts';
import { usePromised } from '../../core/ask/index.ts';
import { LevelContext, useDocument, useEditor, useLevel, useSession } from '../../core/context/index.ts';
import { folderOf, readStored } from '../../core/files/index.ts';
import { addLevels, openListed, stemOf } from '../../core/levels/index.ts';
import { TextDialog } from '../../core/panel/index.ts';
import { Button, Dialog } from '../../core/ui/index.ts';
import { diffLines, valueInWords } from './conflict-text.ts';

/** Asks how to resolve a difference between the file on disk and the page. */
export function ConflictDialog() {
  const editor = useEditor();
  const level = useStore(editor.open);
  const isOpen = useSession((state) => state.overlay === 'conflict');
  if (level === null || !isOpen) return null;
  return (
    <LevelContext.Provider value={level}>
      <Disagreement onClose={() => editor.session.setState({ overlay: null })} />
    </LevelContext.Provider>
  );
}

function Disagreement({ onClose }: { readonly onClose: () => void }) {
  const { opened } = useLevel();
  const state = useStore(opened.saver.store);
  // Text that the user is editing stays open even if the file is fixed in the meantime.
  const [asText, setAsText] = useState(false);
  const undecided = useDocument(({ file }) => file.conflicts?.length ?? 0);
  // resolved in some other way: nothing left to choose
  const isOver = state.kind !== 'conflict' && state.kind !== 'deleted' && state.kind !== 'unreadable' && undecided === 0;
  useEffect(() => {
    if (isOver && !asText) onClose();
  }, [isOver, asText, onClose]);
  if (asText) return <TextDialog id={opened.id()} fromDisk onClose={() => setAsText(false)} />;
  if (state.kind === 'conflict') return <Merge conflicts={state.conflicts} onClose={onClose} />;
  if (state.kind === 'deleted') return <Displaced problems={null} onFix={() => {}} onClose={onClose} />;
  if (state.kind === 'unreadable') return <Displaced problems={state.problems} onFix={() => setAsText(true)} onClose={onClose} />;
  return undecided > 0 ? <Undecided onClose={onClose} /> : null;
}

/** The level on disk; null while it is read or if it is not a valid level. */
function useTheirs(): LevelFile | null {
  const { workspace } = useEditor();
  const { opened } = useLevel();
  const answer = usePromised(opened, () => workspace.storage.read(opened.id()));
  return useMemo(() => {
    const reading = answer?.ok === true ? readStored(answer.value) : null;
    return reading?.ok === true ? reading.file : null;
  }, [answer]);
}

function Merge({ conflicts, onClose }: { readonly conflicts: readonly Conflict[]; readonly onClose: () => void }) {
  const { opened } = useLevel();
  const mine = useDocument(({ file }) => file);
  const theirs = useTheirs();
  const merged = (choices: Choices) => {
    const { file: base, sent } = opened.saver.base();
    return theirs === null ? null : mergeLevels(base, mine, theirs, choices, sent).file;
  };
  return (
    <ChooseSides
      title="Two versions of this level"
      about="It was changed here and on disk. Changes made on one side only are merged automatically; choose a side for each of the others."
      conflicts={conflicts}
      sides={{ mine: ['mine', 'on the screen'], theirs: ['theirs', 'on disk'] }}
      later="Decide later; nothing is saved until then"
      merged={merged}
      onMerge={(choices) => opened.saver.resolve(choices)}
      onClose={onClose}
    />
  );
}

/** Asks how to resolve what a merge outside the editor has left undecided in the file. */
function Undecided({ onClose }: { readonly onClose: () => void }) {
  const { notices } = useEditor();
  const { document } = useLevel();
  const file = useDocument(({ file }) => file);
  const conflicts = useMemo(() => conflictsOf(file), [file]);
  const decide = (choices: Choices) => {
    const all = new Map(conflicts.map(({ key }): [string, Side] => [key, choices.get(key) ?? 'mine']));
    document.seal();
    const result = document.replace('Decide conflicts', resolveConflicts(document.file(), all));
    if (!result.ok) notices.show('warning', `${result.refusal.message}. ${result.refusal.hint}`);
  };
  return (
    <ChooseSides
      title="A merge left conflicts in this level"
      about="Both merged versions changed the same things in different ways. Choose a side for each; the level is refused by checks until then."
      conflicts={conflicts}
      sides={{ mine: ['ours', 'in the level now'], theirs: ['theirs', 'merged in'] }}
      later="Decide later; the file keeps both versions"
      merged={(choices) => resolveConflicts(file, choices)}
      onMerge={decide}
      onClose={onClose}
    />
  );
}

interface ChooseSidesProps {
  readonly title: string;
  readonly about: string;
  readonly conflicts: readonly Conflict[];
  /** What each side is called, and where it is. */
  readonly sides: Readonly<Record<Side, readonly [name: string, where: string]>>;
  /** What the button for later does. */
  readonly later: string;
  /** The result of choices; null while it is not known. */
  readonly merged: (choices: Choices) => LevelFile | null;
  readonly onMerge: (choices: Choices) => void;
  readonly onClose: () => void;
}

function ChooseSides({ title, about, conflicts, sides, later, merged, onMerge, onClose }: ChooseSidesProps) {
  const [choices, setChoices] = useState<Choices>(new Map());
  const all = (side: Side) => setChoices(new Map(conflicts.map(({ key }) => [key, side])));
  const sideOf = (key: string): Side => choices.get(key) ?? 'mine';
  const merge = () => {
    onMerge(choices);
    onClose();
  };
  const result = merged(new Map(conflicts.map(({ key }): [string, Side] => [key, sideOf(key)])));
  return (
    <Dialog open wide title={title} about={about} onClose={onClose}>
      <div className="share__buttons">
        {(['mine', 'theirs'] as const).map((side) => (
          <Button
            key={side}
            hint={`Use the version ${sides[side][1]} for every difference`}
            look="outlined"
            onClick={() => all(side)}
          >
            Use all {sides[side][0]}
          </Button>
        ))}
        <span className="share__about">
          {conflicts.length} {conflicts.length === 1 ? 'difference' : 'differences'} to resolve
        </span>
      </div>
      <div className="conflicts">
        {conflicts.map(({ key, what, base, mine, theirs }) => (
          <fieldset key={key} className="conflict">
            <legend className="conflict__what">{what}</legend>
            {(
              [
                ['mine', mine],
                ['theirs', theirs],
              ] as const
            ).map(([side, value]) => (
              <label key={side} className="conflict__side">
                <input
                  type="radio"
                  name={key}
                  checked={sideOf(key) === side}
                  onChange={() => setChoices(new Map(choices).set(key, side))}
                />
                <span className="conflict__title">{sides[side].join(', ')}</span>
                <span className="conflict__value">{valueInWords(value)}</span>
              </label>
            ))}
            <span className="conflict__base">before: {valueInWords(base)}</span>
          </fieldset>
        ))}
      </div>
      {result !== null && <Preview result={result} />}
      <div className="form__buttons">
        <Button hint={later} look="outlined" onClick={onClose}>
          Later
        </Button>
        <Button hint="Save the chosen version; this can be undone" look="main" onClick={merge}>
          Merge
        </Button>
      </div>
    </Dialog>
  );
}

/** lines of context around a difference */
const AROUND = 2;

function Preview({ result }: { readonly result: LevelFile }) {
  const mine = useDocument(({ file }) => file);
  // what is undecided is shown above
  const shown = ({ conflicts: _, ...file }: LevelFile) => formatLevel(file);
  const lines = diffLines(shown(mine), shown(result));
  const near = lines.map((_, i) => lines.slice(Math.max(0, i - AROUND), i + AROUND + 1).some(({ kind }) => kind !== 'same'));
  return (
    <details className="merged" open>
      <summary>Changes that the merge makes to my version</summary>
      {near.some(Boolean) ? (
        <pre className="merged__text">
          {lines.map(({ kind, text }, i) =>
            near[i] ? (
              // biome-ignore lint/suspicious/noArrayIndexKey: lines of a text are known by their places alone
              <div key={i} className={`merged__line merged__line--${kind}`}>
                {kind === 'old' ? '- ' : kind === 'new' ? '+ ' : '  '}
                {text}
              </div>
            ) : (
              // biome-ignore lint/suspicious/noArrayIndexKey: as above
              near[i - 1] === true && <div key={i}> …</div>
            ),
          )}
        </pre>
      ) : (
        <p className="share__about">None: the result is my version.</p>
      )}
    </details>
  );
}

interface DisplacedProps {
  /** Why the file can't be read; null if it was deleted. */
  readonly problems: readonly Problem[] | null;
  /** Called to fix the file as text. */
  readonly onFix: () => void;
  readonly onClose: () => void;
}

function Displaced({ problems, onFix, onClose }: DisplacedProps) {
  const editor = useEditor();
  const { workspace } = editor;
  const { opened, document } = useLevel();
  const id = opened.id();
  const saveAsNew = async () => {
    const stem = `${stemOf(id)}-mine`;
    const added = await addLevels(editor, folderOf(id), [{ stem, file: document.file() }]);
    if (added.length > 0) onClose();
  };
  const acceptDeletion = async () => {
    onClose();
    await editor.workspace.refresh();
    const next = workspace.store.getState().list?.levels.find((entry) => entry.status === 'valid' && entry.id !== id);
    if (next !== undefined) await openListed(editor, next.id);
    else {
      workspace.store.setState({ opened: null });
      await opened.close();
    }
  };
  const isDeleted = problems === null;
  return (
    <Dialog
      open
      title={isDeleted ? 'The file was deleted' : "The file can't be read"}
      about={
        isDeleted
          ? `${id}.level.json was deleted or moved outside this page. The level on the screen is still complete.`
          : `${id}.level.json was changed outside this page and is no longer a valid level. The page shows the last valid state and continues by itself once the file is fixed.`
      }
      onClose={onClose}
    >
      {problems !== null && (
        <ul className="displaced__problems">
          {problems.slice(0, 3).map(({ code, pointer, line, column, message, hint }) => (
            <li key={`${code} ${pointer} ${line}`}>
              {line !== null && <span className="astext__place">{`${line}:${column} `}</span>}
              {message}. <span className="astext__hint">{hint}</span>
            </li>
          ))}
        </ul>
      )}
      <div className="displaced">
        <Button
          hint="Save the level on the screen to the file"
          look="main"
          onClick={() => {
            opened.saver.keepMine();
            onClose();
          }}
        >
          Keep mine and save it
        </Button>
        <Button hint="Save the level on the screen under another name" look="outlined" onClick={() => void saveAsNew()}>
          Save mine as a new level
        </Button>
        {isDeleted ? (
          <Button hint="Close this level; the file stays deleted" look="danger" onClick={() => void acceptDeletion()}>
            Accept the deletion and close
          </Button>
        ) : (
          <Button hint="Show the file on disk and fix it" look="outlined" onClick={onFix}>
            Fix the file as text
          </Button>
        )}
      </div>
    </Dialog>
  );
}

import { Dices } from 'lucide-react';
import { useEffect, useId, useMemo, useRef, useState } from 'react';
import { useStore } from 'zustand';
import { compile, simulate, type Terms } from '../../../engine/index.ts';
import { renderSvg } from '../../../picture/index.ts';
import { type LevelFile, resolveLevel } from '../../../schema/index.ts';
import { useEditor, useOverlay, usePageTerms, usePageTheme } from '../../core/context/index.ts';
import { slugOf } from '../../core/exchange/index.ts';
import { folderOf } from '../../core/files/index.ts';
import { addLevels, nextNumber } from '../../core/levels/index.ts';
import { TEMPLATES, type Template } from '../../core/templates/index.ts';
import { Button, Dialog, NumberField } from '../../core/ui/index.ts';
import { FileNameFields, fileNameProblem } from './FileNameFields.tsx';

/** Pictures wider than this ratio are shown whole; cropping the sides would cut off objects. */
const WIDE = 1.5;

/** Random seeds stay below this, short enough to pass on. */
const SEEDS = 10_000;
const throwDice = () => 1 + (crypto.getRandomValues(new Uint32Array(1))[0] % SEEDS);

/** The dialog that makes a new level from a template. */
export function NewLevelDialog() {
  const dialog = useOverlay('newLevel');
  return (
    <Dialog {...dialog} wide title="New level" about="Choose a template. Everything can be changed later.">
      <NewLevel onClose={dialog.onClose} />
    </Dialog>
  );
}

function NewLevel({ onClose }: { readonly onClose: () => void }) {
  const editor = useEditor();
  const { workspace } = editor;
  const levels = useStore(workspace.store, (state) => state.list?.levels) ?? [];
  const [template, setTemplate] = useState<Template>(TEMPLATES[0]);
  const [seed, setSeed] = useState(throwDice);
  const [name, setName] = useState('New level');
  // null: derived from the name
  const [typed, setTyped] = useState<string | null>(null);
  const [folder, setFolder] = useState(() => folderOf(workspace.store.getState().opened?.id() ?? ''));
  const [busy, setBusy] = useState(false);
  const field = useId();
  const nameField = useRef<HTMLInputElement>(null);
  // The name is typed first; Shift+Tab leads to the templates.
  useEffect(() => nameField.current?.focus(), []);
  const stem = typed ?? `${nextNumber(levels, folder)}${slugOf(name)}`;
  const problem = fileNameProblem(
    folder,
    stem,
    levels.map(({ id }) => id),
  );
  const ready = problem === null && name.trim() !== '' && !busy;

  const create = async () => {
    if (!ready) return;
    setBusy(true);
    const added = await addLevels(editor, folder, [{ stem, file: template.make(name.trim(), seed) }]);
    if (added.length > 0) onClose();
    else setBusy(false);
  };

  return (
    <form
      className="form newlevel"
      onSubmit={(event) => {
        event.preventDefault();
        void create();
      }}
    >
      <fieldset className="newlevel__templates">
        <legend className="unseen">Template</legend>
        {TEMPLATES.map((one) => (
          <TemplateCard key={one.id} template={one} seed={seed} checked={one === template} onPick={() => setTemplate(one)} />
        ))}
      </fieldset>
      {template.usesSeed && (
        <div className="newlevel__seed">
          <NumberField label="Seed" value={seed} min={0} max={4_294_967_295} whole onChange={setSeed} />
          <Button
            hint="Another seed gives another level"
            look="outlined"
            icon={<Dices size={15} />}
            onClick={() => setSeed(throwDice())}
          >
            New seed
          </Button>
        </div>
      )}
      <label htmlFor={`${field}-name`}>Level name</label>
      <input
        id={`${field}-name`}
        className="field"
        value={name}
        maxLength={120}
        ref={nameField}
        onFocus={(event) => event.target.select()}
        onChange={(event) => setName(event.target.value)}
      />
      <FileNameFields {...{ stem, folder, problem }} onStem={setTyped} onFolder={setFolder} />
      <div className="form__buttons">
        <Button hint="Close without creating a level" look="outlined" onClick={onClose}>
          Cancel
        </Button>
        <Button hint="Create the level and open it" look="main" type="submit" disabled={!ready}>
          Create
        </Button>
      </div>
    </form>
  );
}

interface TemplateCardProps {
  readonly template: Template;
  readonly seed: number;
  readonly checked: boolean;
  readonly onPick: () => void;
}

function TemplateCard({ template, seed, checked, onPick }: TemplateCardProps) {
  const theme = usePageTheme();
  const { folder: terms } = usePageTerms();
  // Templates without randomness ignore the seed.
  const shownSeed = template.usesSeed ? seed : 0;
  const picture = useMemo(
    () => levelPicture(template.make(template.title, shownSeed), { terms, theme, width: 480 }),
    [template, shownSeed, terms, theme],
  );
  return (
    <label className="newlevel__template">
      <input type="radio" name="template" checked={checked} onChange={onPick} />
      <img
        src={picture}
        alt=""
        onLoad={({ currentTarget: { naturalWidth, naturalHeight, classList } }) =>
          classList.toggle('newlevel__wide', naturalWidth > WIDE * naturalHeight)
        }
      />
      <strong>{template.title}</strong>
      <span>{template.about}</span>
    </label>
  );
}

interface PictureOptions {
  readonly terms: Terms;
  readonly theme: 'dark' | 'light';
  /** px */
  readonly width: number;
}

/** A data URL of an SVG picture of a level with its first run. */
function levelPicture(file: LevelFile, { terms, theme, width }: PictureOptions): string {
  const level = resolveLevel(file, terms.rules);
  const run = level.runs.length === 0 ? undefined : simulate(compile(level, terms), level.runs[0].holds);
  return `data:image/svg+xml,${encodeURIComponent(renderSvg(level, { run, width, theme, words: false }))}`;
}

import { Dices } from 'lucide-react';
import { useEffect, useId, useMemo, useRef, useState } from 'react';
import { useStore } from 'zustand';
import { useEditor, useFolderRules, usePageTheme, useSession } from '../context/index.ts';
import { folderOf } from '../files/index.ts';
import { addLevels, FileNameFields, fileNameProblem, nextNumber } from '../panels/levels/index.ts';
import { slugOf } from '../share/index.ts';
import { TEMPLATES, type Template } from '../templates/index.ts';
import { Button, Dialog, NumberField } from '../ui/index.ts';
import { levelPicture } from './level-picture.ts';

/** Pictures that are wider than this are shown whole: cut at the sides they would lose what is in them. */
const WIDE = 1.5;

/** Seeds that dice throw: short enough to be told to somebody. */
const SEEDS = 10_000;
const throwDice = () => 1 + (crypto.getRandomValues(new Uint32Array(1))[0] % SEEDS);

/** A new level from a template. */
export function NewLevelDialog() {
  const { session } = useEditor();
  const open = useSession((state) => state.overlay === 'newLevel');
  const close = () => session.setState({ overlay: null });
  return (
    <Dialog
      open={open}
      wide
      title="New level"
      about="Choose what it begins with. Everything can be changed later."
      onClose={close}
    >
      <NewLevel onClose={close} />
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
  // null: it follows the name
  const [typed, setTyped] = useState<string | null>(null);
  const [folder, setFolder] = useState(() => folderOf(workspace.store.getState().opened?.id() ?? ''));
  const [busy, setBusy] = useState(false);
  const field = useId();
  const nameField = useRef<HTMLInputElement>(null);
  // what is typed first; templates are a step back
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
            hint="Throw again: another seed, another level"
            look="outlined"
            icon={<Dices size={15} />}
            onClick={() => setSeed(throwDice())}
          >
            Throw again
          </Button>
        </div>
      )}
      <label htmlFor={`${field}-name`}>Name of the level</label>
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
        <Button hint="No new level" look="outlined" onClick={onClose}>
          Cancel
        </Button>
        <Button hint="Make the level and open it" look="main" type="submit" disabled={!ready}>
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
  const { settings } = useEditor();
  const accuracy = useStore(settings, (state) => state.accuracy);
  const theme = usePageTheme();
  const rules = useFolderRules().own;
  // templates that throw nothing are the same for every seed
  const shownSeed = template.usesSeed ? seed : 0;
  const picture = useMemo(
    () => levelPicture(template.make(template.title, shownSeed), { rules, accuracy, theme, width: 480 }),
    [template, shownSeed, rules, accuracy, theme],
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

import { useId, useState } from 'react';
import { useStore } from 'zustand';
import { type OpenLevel, useEditor, useLevel, useOverlay } from '../../core/context/index.ts';
import { Button, Dialog } from '../../core/ui/index.ts';
import type { Version } from '../../core/versions/index.ts';
import { whyNot } from './restore.ts';

/** The dialog that gives the level as it is now a name. */
export function NameVersionDialog() {
  const level = useStore(useEditor().open);
  const dialog = useOverlay('nameVersion');
  return (
    <Dialog
      {...dialog}
      title="Name this version"
      about="The level as it is now is kept in its history under this name, in this browser only."
    >
      {level === null ? <p>Open a level first.</p> : <NameVersion level={level} onClose={dialog.onClose} />}
    </Dialog>
  );
}

function NameVersion({ level, onClose }: { readonly level: OpenLevel; readonly onClose: () => void }) {
  const { notices } = useEditor();
  const field = useId();
  const [typed, setTyped] = useState('');
  const [why, setWhy] = useState('');
  const [busy, setBusy] = useState(false);
  const name = typed.trim();
  const keep = async () => {
    const refusal = whyNot(level);
    if (name === '' || busy || refusal !== null) {
      setWhy(refusal ?? '');
      return;
    }
    setBusy(true);
    const isKept = await level.opened.versions.nameNow(name);
    setBusy(false);
    if (!isKept) {
      setWhy("The version can't be kept: the browser's database does not answer or is full.");
      return;
    }
    notices.show('info', `This version is kept as "${name}".`, { topic: 'history' });
    onClose();
  };
  return (
    <form
      className="form"
      onSubmit={(event) => {
        event.preventDefault();
        void keep();
      }}
    >
      <label htmlFor={field}>Name</label>
      <input
        id={field}
        className="field"
        type="text"
        maxLength={LONGEST_NAME}
        value={typed}
        onChange={({ currentTarget }) => setTyped(currentTarget.value)}
      />
      {why !== '' && (
        <p className="form__problem" role="alert">
          {why}
        </p>
      )}
      <div className="form__buttons">
        <Button hint="Close without a name" onClick={onClose}>
          Cancel
        </Button>
        <Button type="submit" hint="Keep this version under this name" look="main" disabled={name === '' || busy}>
          Name it
        </Button>
      </div>
    </form>
  );
}

/** the longest name of a version, characters */
const LONGEST_NAME = 100;

/** The name of a version, which can be changed or taken away. */
export function VersionName({ version }: { readonly version: Version }) {
  const level = useLevel();
  const [typed, setTyped] = useState(version.name ?? '');
  const [said, setSaid] = useState('');
  const name = typed.trim();
  const isSame = name === (version.name ?? '');
  const keep = async () => {
    const why = whyNot(level);
    if (isSame || why !== null) {
      setSaid(why ?? '');
      return;
    }
    const isKept = await level.opened.versions.rename(version, name === '' ? null : name);
    setSaid(isKept ? (name === '' ? 'The name is removed.' : 'Named.') : "The name can't be kept: the database does not answer.");
  };
  return (
    <form
      className="history__naming"
      onSubmit={(event) => {
        event.preventDefault();
        void keep();
      }}
    >
      <input
        className="field"
        type="text"
        aria-label="Name of this version"
        placeholder="No name: give it one to keep it for good"
        maxLength={LONGEST_NAME}
        value={typed}
        onChange={({ currentTarget }) => setTyped(currentTarget.value)}
      />
      <Button type="submit" hint="Keep the name" look="outlined" disabled={isSame}>
        {name === '' && !isSame ? 'Remove name' : 'Name it'}
      </Button>
      <output className="history__said">{said}</output>
    </form>
  );
}

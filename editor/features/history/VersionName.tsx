import { useState } from 'react';
import { useLevel } from '../../core/context/index.ts';
import { Button } from '../../core/ui/index.ts';
import type { Version } from '../../core/versions/index.ts';
import { whyNot } from './restore.ts';

/** the longest name of a version, characters */
export const LONGEST_NAME = 100;

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

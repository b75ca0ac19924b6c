import { useEffect, useMemo, useState } from 'react';
import type { LevelFile } from '../../../schema/index.ts';
import { useDocument, useEditor, useLevel, usePageTerms, usePageTheme } from '../../context/index.ts';
import { levelText } from '../../document/index.ts';
import { readText } from '../../files/index.ts';
import type { Version } from '../../versions/index.ts';
import { jobs, type Results } from '../../workers/index.ts';
import { type Difference, differencesBetween } from './differences.ts';

/** A version that is compared: loading, damaged, or there. */
export type ReadVersion = LevelFile | 'loading' | 'damaged';

/** With what a version is compared: the level as it is now, or the version before it. */
export type ComparedWith = 'now' | 'previous';

/** The file of a version. */
function useVersionFile(version: Version | null): ReadVersion {
  const { versions } = useLevel().opened;
  const [read, setRead] = useState<{ readonly of: Version | null; readonly file: ReadVersion }>({ of: null, file: 'loading' });
  const check = version?.check;
  // biome-ignore lint/correctness/useExhaustiveDependencies: a version that is renamed is read only once
  useEffect(() => {
    if (version === null) return;
    let isGone = false;
    void versions.text(version).then((text) => {
      if (isGone) return;
      const reading = text === null ? null : readText(text);
      setRead({ of: version, file: reading?.ok === true ? reading.file : 'damaged' });
    });
    return () => {
      isGone = true;
    };
  }, [versions, check]);
  return read.of !== null && read.of.check === check ? read.file : 'loading';
}

/** Two versions and what differs. */
export interface Comparison {
  readonly version: ReadVersion;
  /** The earlier one of the two that are compared, and the later one; null while they are not known. */
  readonly before: LevelFile | null;
  readonly after: LevelFile | null;
  /** null while it is not known */
  readonly differences: readonly Difference[] | null;
  /** The picture and what is true of both; null while it is made; a text if it can't be made. */
  readonly drawn: Results['compare'] | string | null;
}

const fileOf = (read: ReadVersion): LevelFile | null => (typeof read === 'string' ? null : read);

/** Compares a version with the present level, or with the version before it. */
export function useComparison(version: Version, previous: Version | null, compared: ComparedWith): Comparison {
  const editor = useEditor();
  const theme = usePageTheme();
  const { folder: terms } = usePageTerms();
  const now = useDocument(({ file }) => file);
  const own = useVersionFile(version);
  const earlier = useVersionFile(compared === 'previous' ? previous : null);
  const before = compared === 'now' ? fileOf(own) : fileOf(earlier);
  const after = compared === 'now' ? now : fileOf(own);
  const differences = useMemo(
    () => (before === null || after === null ? null : differencesBetween(before, after)),
    [before, after],
  );
  const [made, setMade] = useState<{ before: LevelFile; after: LevelFile; drawn: Results['compare'] | string } | null>(null);
  useEffect(() => {
    if (before === null || after === null) return;
    const texts = { before: levelText(before), after: levelText(after) };
    const job = editor.workers.start(jobs.compare, { ...texts, terms, theme, width: 960 });
    void job.end.then((end) => {
      if (end.kind === 'done') setMade({ before, after, drawn: end.result });
      else if (end.kind !== 'cancelled') setMade({ before, after, drawn: end.message });
    });
    return () => job.cancel();
  }, [editor, before, after, terms, theme]);
  const drawn = made !== null && made.before === before && made.after === after ? made.drawn : null;
  return { version: own, before, after, differences, drawn };
}

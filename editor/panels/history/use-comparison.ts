import { useEffect, useMemo, useState } from 'react';
import type { LevelFile } from '../../../schema/index.ts';
import { question, useQuestion, type Wanted } from '../../ask/index.ts';
import { useDocument, useEditor, useLevel, usePageTerms, usePageTheme } from '../../context/index.ts';
import { levelText } from '../../document/index.ts';
import { readText } from '../../files/index.ts';
import type { Version } from '../../versions/index.ts';
import { type AnswerOf, type AskedOf, jobs } from '../../workers/index.ts';
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
  readonly drawn: AnswerOf<typeof jobs.compare> | string | null;
}

const fileOf = (read: ReadVersion): LevelFile | null => (typeof read === 'string' ? null : read);

/** Two versions in one picture. */
export const comparisonQuestion = question({
  job: jobs.compare,
  request: (of: AskedOf<typeof jobs.compare>) => of,
  follows: {
    wait: { rest: 0 },
    of: (wanted: Wanted<AskedOf<typeof jobs.compare>>) => wanted.getState(),
    same: (asked, now) => asked === now,
    on: (wanted) => [wanted.subscribe],
  },
});

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
  const of = useMemo(() => {
    if (before === null || after === null) return null;
    return { before: levelText(before), after: levelText(after), terms, theme, width: 960 };
  }, [before, after, terms, theme]);
  const asked = useQuestion(comparisonQuestion, editor.desk, of);
  const drawn = asked?.of === of && of !== null ? (asked.answer ?? asked.message) : null;
  return { version: own, before, after, differences, drawn };
}

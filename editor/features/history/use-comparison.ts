import { useEffect, useMemo, useState } from 'react';
import { type Change, changesInWords, diffLevels } from '../../../review/index.ts';
import {
  KINDS,
  kindOfList,
  type LevelFile,
  type ObjectKind,
  type ObjectList,
  objectName,
  SINGLE_KINDS,
} from '../../../schema/index.ts';
import { question, useQuestion, type Wanted } from '../../core/ask/index.ts';
import { useDocument, useEditor, useLevel, usePageTerms, usePageTheme } from '../../core/context/index.ts';
import { levelText, titled } from '../../core/document/index.ts';
import { readText } from '../../core/files/index.ts';
import type { Version } from '../../core/versions/index.ts';
import { type AnswerOf, type AskedOf, jobs } from '../../workers/index.ts';

/** With what a version is compared: the level as it is now, or the version before it. */
export type ComparedWith = 'now' | 'previous';

/** Two versions and what differs. */
interface Comparison {
  readonly version: ReadVersion;
  /** The earlier one of the two that are compared, and the later one; null while they are not known. */
  readonly before: LevelFile | null;
  readonly after: LevelFile | null;
  /** null while it is not known */
  readonly differences: readonly Difference[] | null;
  /** The picture and what is true of both; null while it is made; a text if it can't be made. */
  readonly drawn: AnswerOf<typeof jobs.compare> | string | null;
}

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

/** A version that is compared: loading, damaged, or there. */
type ReadVersion = LevelFile | 'loading' | 'damaged';

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

const fileOf = (read: ReadVersion): LevelFile | null => (typeof read === 'string' ? null : read);

// what differs, in parts that can be taken back

/** What differs about one object, run or part of the level. */
export interface Difference {
  readonly key: string;
  /** What it is about; null where the words of its only part say so. */
  readonly title: string | null;
  readonly parts: readonly DifferencePart[];
}

/** A difference that can be taken back alone. */
export interface DifferencePart {
  readonly key: string;
  readonly words: string;
  readonly change: Change;
}

/** What differs between two versions of a level, in the words of `gq diff`, for each object and run. */
export function differencesBetween(before: LevelFile, after: LevelFile): Difference[] {
  return diffLevels(before, after).map((change) => {
    const key = keyOf(change);
    const parts = partsOf(change).map(([group, part]) => ({
      key: `${key} ${group}`,
      words: titled(changesInWords([part], after).join('; ')) || 'Changed',
      change: part,
    }));
    return { key, title: parts.length > 1 ? titleOf(change, after) : null, parts };
  });
}

const objectKindOf = (of: string): ObjectKind | null =>
  SINGLE_KINDS.find((kind) => kind === of) ?? (of === 'runs' ? null : kindOfList(of as ObjectList));

/** Which fields are taken back together: the places of an object, else each alone. */
function groupOf(kind: ObjectKind | null, key: string): string {
  return kind !== null && KINDS[kind].places.flat().includes(key) ? 'place' : key;
}

/** A change in parts, each about one property. */
function partsOf(change: Change): readonly (readonly [key: string, part: Change])[] {
  if (change.type !== 'changed' && change.type !== 'map') return [['', change]];
  const kind = change.type === 'map' ? null : objectKindOf(change.of);
  const groups = new Map<string, (typeof change.fields)[number][]>();
  for (const field of change.fields) {
    const group = groupOf(kind, field.key);
    groups.set(group, [...(groups.get(group) ?? []), field]);
  }
  // an order of x- keys makes sense with all fields only
  if (groups.size < 2 || change.keys !== null) return [['', change]];
  return [...groups].map(([group, fields]) => [group, { ...change, fields }]);
}

function titleOf(change: Change, after: LevelFile): string | null {
  if (change.type === 'map') return titled(change.of);
  if (change.type !== 'changed') return null;
  const kind = objectKindOf(change.of);
  if (kind === null) return `Run "${(after.runs ?? [])[change.after]?.name}"`;
  const single = SINGLE_KINDS.find((one) => one === kind);
  const object = single === undefined ? (after[change.of as ObjectList] ?? [])[change.after] : after[single];
  return titled(objectName(kind, change.after, object as never));
}

/** A key that stays the same as long as the change is about the same thing. */
function keyOf(change: Change): string {
  if (change.type === 'value') return `value ${change.key}`;
  if (!('of' in change)) return change.type;
  if (change.type === 'added' || change.type === 'removed') return `${change.type} ${change.of} ${change.index}`;
  return change.type === 'changed' ? `changed ${change.of} ${change.after}` : `${change.type} ${change.of}`;
}

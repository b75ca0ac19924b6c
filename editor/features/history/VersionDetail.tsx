import { ArrowLeft, Copy, RotateCcw } from 'lucide-react';
import { useMemo, useState } from 'react';
import { useEditor, useLevel } from '../../core/context/index.ts';
import { plural } from '../../core/figures/index.ts';
import { Segments } from '../../core/panel/index.ts';
import { Button } from '../../core/ui/index.ts';
import type { Version } from '../../core/versions/index.ts';
import type { Results } from '../../workers/index.ts';
import { VersionName } from './NameVersionDialog.tsx';
import { openAsCopy, type Restored, restoreVersion, takeBackParts } from './restore.ts';
import { type ComparedWith, type Difference, type DifferencePart, useComparison } from './use-comparison.ts';
import { momentInWords, stepsInWords, whoInWords } from './version-rows.ts';

interface VersionDetailProps {
  readonly version: Version;
  /** All versions, oldest first. */
  readonly versions: readonly Version[];
  /** Goes back to the list, where there is no room beside it. */
  readonly onBack: () => void;
  readonly onClose: () => void;
}

/** A version: what it is, what differs, and what can be brought back. */
export function VersionDetail({ version, versions, onBack, onClose }: VersionDetailProps) {
  const editor = useEditor();
  const level = useLevel();
  const [compared, setCompared] = useState<ComparedWith>('now');
  const [told, setTold] = useState<{ readonly text: string; readonly isRefusal: boolean } | null>(null);
  const previous = useMemo(() => versions.findLast(({ number }) => number < version.number) ?? null, [versions, version.number]);
  const comparison = useComparison(version, previous, compared);
  const { differences, before, after, drawn } = comparison;
  const file = typeof comparison.version === 'string' ? null : comparison.version;
  const when = momentInWords(version.time, Date.now());
  const tell = (result: Restored, done: string) =>
    setTold(result.ok ? { text: done, isRefusal: false } : { text: result.why, isRefusal: true });
  const restore = () => {
    if (file === null) return;
    const result = restoreVersion(level, file, when);
    if (result.ok) onClose();
    else tell(result, '');
  };
  return (
    <section className="history__detail" aria-label={`Version of ${when}`}>
      <div className="history__head">
        <Button className="history__back" hint="Back to the list" icon={<ArrowLeft size={16} />} onClick={onBack} />
        <div className="history__about">
          <h3 className="history__title">{when}</h3>
          <p className="history__by">
            {version.labels.length > 0 && `${stepsInWords(version)}. `}
            {whoInWords(version)}
          </p>
        </div>
      </div>
      <VersionName version={version} />
      <div className="history__actions">
        <Button
          hint="Replace the level by this version, as one step that can be undone"
          look="main"
          icon={<RotateCcw size={14} />}
          disabled={file === null || (compared === 'now' && differences?.length === 0)}
          onClick={restore}
        >
          Restore
        </Button>
        <Button
          hint="Make a new level of this version and open it"
          look="outlined"
          icon={<Copy size={14} />}
          disabled={file === null}
          onClick={() => file !== null && void openAsCopy(editor, level.opened.id(), file).then((isMade) => isMade && onClose())}
        >
          Open as a copy
        </Button>
      </div>
      {comparison.version === 'damaged' && (
        <p role="alert">This version can't be read: the browser's database has lost a part of it. The others are not affected.</p>
      )}
      <Segments
        label="Compare"
        value={compared}
        options={[
          { value: 'now', title: 'With now', about: 'What has changed since this version' },
          { value: 'previous', title: 'With the one before', about: 'What this version has changed' },
        ]}
        onChange={setCompared}
      />
      {compared === 'previous' && previous === null ? (
        <p className="history__empty">This is the first version that is kept.</p>
      ) : (
        <>
          <DifferenceList
            differences={differences}
            title={compared === 'now' ? 'Changed since then' : 'Changed by this version'}
            same={compared === 'now' ? 'Nothing has changed since: this is the level as it is now.' : 'Nothing differs.'}
            onTakeBack={
              compared === 'now' && before !== null && after !== null
                ? (parts) => {
                    const result = takeBackParts(level, before, after, parts);
                    tell(result, parts.length === 1 ? 'Taken back. Undo brings it again.' : 'Taken back as one step.');
                    return result.ok;
                  }
                : null
            }
          />
          <output className={told?.isRefusal ? 'history__told history__told--refusal' : 'history__told'}>{told?.text}</output>
          {differences !== null && differences.length > 0 && <ComparisonPicture drawn={drawn} />}
        </>
      )}
    </section>
  );
}

/** Both versions in one picture, and what is true of each. @param drawn null while it is made; a text if it can't be made */
function ComparisonPicture({ drawn }: { readonly drawn: Results['compare'] | string | null }) {
  if (drawn === null) return <p className="history__empty">Drawing both versions…</p>;
  if (typeof drawn === 'string') return <p className="history__empty">The picture can't be made: {drawn}</p>;
  const { svg, before, after, effects } = drawn;
  return (
    <>
      <dl className="history__standings">
        <dt>Before</dt>
        <dd>{before}</dd>
        <dt>After</dt>
        <dd>{after}</dd>
        {effects.length > 0 && (
          <>
            <dt>Effect</dt>
            <dd>{effects.join(', ')}</dd>
          </>
        )}
      </dl>
      {svg !== null && (
        <img
          className="history__picture"
          src={`data:image/svg+xml,${encodeURIComponent(svg)}`}
          alt="Both versions of the level"
        />
      )}
    </>
  );
}

interface DifferenceListProps {
  /** null while they are not known */
  readonly differences: readonly Difference[] | null;
  readonly title: string;
  /** Said where there are none. */
  readonly same: string;
  /** Takes parts back. @returns whether it did; null: they can only be looked at */
  readonly onTakeBack: ((parts: readonly DifferencePart[]) => boolean) | null;
}

/** The most differences that are listed; more are counted. */
const MOST = 300;

/** What differs, grouped by object; parts can be chosen and taken back. */
function DifferenceList({ differences, title, same, onTakeBack }: DifferenceListProps) {
  const [chosen, setChosen] = useState<ReadonlySet<string>>(new Set());
  if (differences === null) return <p className="history__empty">Comparing…</p>;
  if (differences.length === 0) return <p className="history__empty">{same}</p>;
  const parts = differences.flatMap((difference) => difference.parts);
  const wanted = parts.filter(({ key }) => chosen.has(key));
  const choose = (keys: readonly string[], isChosen: boolean) =>
    setChosen(new Set([...[...chosen].filter((key) => !keys.includes(key)), ...(isChosen ? keys : [])]));
  const line = (part: DifferencePart) => (
    <li key={part.key} className="history__part">
      {onTakeBack === null ? (
        part.words
      ) : (
        <label className="history__choice">
          <input
            type="checkbox"
            checked={chosen.has(part.key)}
            onChange={({ currentTarget }) => choose([part.key], currentTarget.checked)}
          />
          {part.words}
        </label>
      )}
    </li>
  );
  const takeAway = () => {
    if (onTakeBack?.(wanted) === true) setChosen(new Set());
  };
  return (
    <div className="history__differences">
      <h4 className="history__subtitle">{title}</h4>
      <ul className="history__changes">
        {differences.slice(0, MOST).map((difference) => {
          if (difference.title === null) return difference.parts.map(line);
          const keys = difference.parts.map(({ key }) => key);
          return (
            <li key={difference.key} className="history__group">
              {onTakeBack === null ? (
                difference.title
              ) : (
                <label className="history__choice">
                  <input
                    type="checkbox"
                    ref={(box) => {
                      if (box !== null)
                        box.indeterminate = keys.some((key) => chosen.has(key)) && !keys.every((key) => chosen.has(key));
                    }}
                    checked={keys.every((key) => chosen.has(key))}
                    onChange={({ currentTarget }) => choose(keys, currentTarget.checked)}
                  />
                  {difference.title}
                </label>
              )}
              <ul className="history__changes">{difference.parts.map(line)}</ul>
            </li>
          );
        })}
        {differences.length > MOST && (
          <li>and {plural(differences.length - MOST, 'more difference')}; Restore takes all of them back</li>
        )}
      </ul>
      {onTakeBack !== null && (
        <Button
          className="history__take"
          hint="Take the chosen changes back, as one step that can be undone"
          look="outlined"
          disabled={wanted.length === 0}
          onClick={takeAway}
        >
          {wanted.length === 0 ? 'Take back what is chosen' : `Take back ${plural(wanted.length, 'change')}`}
        </Button>
      )}
    </div>
  );
}

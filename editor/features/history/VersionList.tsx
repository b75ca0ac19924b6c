import { useMemo, useState } from 'react';
import { Segments } from '../../core/panel/index.ts';
import { Tree } from '../../core/tree/index.ts';
import type { Version } from '../../core/versions/index.ts';
import { type HistoryRow, historyRows, keyOf } from './history-rows.ts';
import { VersionLine } from './VersionLine.tsx';

interface VersionListProps {
  readonly versions: readonly Version[];
  /** The number of the version that is shown; null: none. */
  readonly picked: number | null;
  readonly onPick: (number: number) => void;
}

/** px */
const rowHeight = ({ version }: HistoryRow) => (version === null ? 30 : 66);

/** The versions, newest first, by day. */
export function VersionList({ versions, picked, onPick }: VersionListProps) {
  const [shown, setShown] = useState<'all' | 'named'>('all');
  const [folded, setFolded] = useState<ReadonlySet<string>>(new Set());
  const [active, setActive] = useState<string | null>(picked === null ? null : keyOf({ number: picked }));
  // the words of a list that is open for hours may lag behind the clock
  const [now] = useState(() => Date.now());
  const rows = useMemo(
    () =>
      historyRows(
        shown === 'all' ? versions : versions.filter(({ name }) => name !== null),
        Math.max(now, versions.at(-1)?.time ?? now),
        folded,
      ),
    [versions, shown, now, folded],
  );
  const selected = useMemo(() => new Set(picked === null ? [] : [keyOf({ number: picked })]), [picked]);
  return (
    <>
      <Segments
        label="Versions"
        value={shown}
        options={[
          { value: 'all', title: `All ${versions.length}` },
          { value: 'named', title: `Named ${versions.filter(({ name }) => name !== null).length}` },
        ]}
        onChange={setShown}
      />
      {rows.length === 0 ? (
        <p className="history__empty">No version has a name yet.</p>
      ) : (
        <Tree
          label="Versions"
          rows={rows}
          rowHeight={rowHeight}
          selected={selected}
          active={active}
          follows
          onActive={setActive}
          onPick={({ version }) => version !== null && onPick(version.number)}
          onToggle={({ day }) =>
            setFolded((days) => (days.has(day) ? new Set([...days].filter((other) => other !== day)) : new Set([...days, day])))
          }
          render={(row) =>
            row.version === null ? (
              <span className="history__day">
                {row.day} <span className="history__count">{row.count}</span>
              </span>
            ) : (
              <VersionLine version={row.version} now={now} />
            )
          }
        />
      )}
    </>
  );
}

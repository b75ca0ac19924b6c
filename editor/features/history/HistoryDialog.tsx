import { Bookmark, Download, HardDrive, Upload } from 'lucide-react';
import { useEffect, useMemo, useRef, useState } from 'react';
import { useStore } from 'zustand';
import type { Terms } from '../../../engine/index.ts';
import { usePromised } from '../../core/ask/index.ts';
import {
  type Editor,
  LevelContext,
  type OpenLevel,
  PerLevel,
  useEditor,
  useLevel,
  useOverlay,
  usePageTerms,
  usePageTheme,
} from '../../core/context/index.ts';
import { VerdictSign } from '../../core/levels/index.ts';
import { Segments } from '../../core/panel/index.ts';
import { pictureKey, picturesOf } from '../../core/pictures/index.ts';
import { Tree, toggledIn } from '../../core/tree/index.ts';
import { Button, Dialog } from '../../core/ui/index.ts';
import type { Version } from '../../core/versions/index.ts';
import { exportHistory, importHistory } from './history-file.ts';
import { VersionDetail } from './VersionDetail.tsx';
import { agoInWords, clockTime, type HistoryRow, historyRows, keyOf, stepsInWords } from './version-rows.ts';

/** The dialog with the versions of the open level. */
export function HistoryDialog() {
  const level = useStore(useEditor().open);
  const dialog = useOverlay('history');
  return (
    <Dialog
      {...dialog}
      wide
      title="History"
      about="Every saved version of this level, kept in this browser only. Those with a name stay for good."
    >
      {level === null ? (
        <p>Open a level first.</p>
      ) : (
        <LevelContext.Provider value={level}>
          <PerLevel>
            <History onClose={dialog.onClose} />
          </PerLevel>
        </LevelContext.Provider>
      )}
    </Dialog>
  );
}

function History({ onClose }: { readonly onClose: () => void }) {
  const editor = useEditor();
  const level = useLevel();
  const { versions } = level.opened;
  const list = useStore(versions.store);
  const trouble = useStore(editor.versions.trouble);
  const [picked, setPicked] = useState<number | null>(null);
  const [said, setSaid] = useState('');
  const root = useRef<HTMLDivElement>(null);
  const isRead = usePromised(versions, (asked) => asked.load().then(() => true)) !== null;
  const isThere = isRead && list !== null && list.length > 0;
  // the dialog itself takes the focus when it opens
  useEffect(() => {
    if (!isThere) return;
    const frame = requestAnimationFrame(() => root.current?.querySelector<HTMLElement>('[role=tree]')?.focus());
    return () => cancelAnimationFrame(frame);
  }, [isThere]);
  const version = list?.find(({ number }) => number === picked) ?? null;
  return (
    <div ref={root} className={version === null ? 'history' : 'history history--picked'}>
      {trouble !== null && (
        <p className="history__trouble" role="alert">
          {trouble.message}
        </p>
      )}
      <div className="history__list">
        {!isRead ? (
          <p className="history__empty">Loading…</p>
        ) : list === null || list.length === 0 ? (
          <p className="history__empty">No versions yet: each save adds one.</p>
        ) : (
          <VersionList versions={list} picked={picked} onPick={setPicked} />
        )}
        <div className="history__file">
          <Button
            hint="Save all versions as one file"
            look="outlined"
            icon={<Download size={14} />}
            disabled={!isThere}
            onClick={() => void exportHistory(level).then(setSaid)}
          >
            Export
          </Button>
          <Button
            hint="Add the versions of a file that was exported"
            look="outlined"
            icon={<Upload size={14} />}
            onClick={() => void importHistory(level).then(setSaid)}
          >
            Import
          </Button>
          <output className="history__said">{said}</output>
        </div>
      </div>
      {version === null ? (
        <p className="history__detail history__empty">Choose a version to see what has changed since.</p>
      ) : (
        <VersionDetail
          key={version.number}
          version={version}
          versions={list ?? []}
          onBack={() => {
            setPicked(null);
            root.current?.querySelector<HTMLElement>('[role=tree]')?.focus();
          }}
          onClose={onClose}
        />
      )}
    </div>
  );
}

interface VersionListProps {
  readonly versions: readonly Version[];
  /** The number of the version that is shown; null: none. */
  readonly picked: number | null;
  readonly onPick: (number: number) => void;
}

/** px */
const rowHeight = ({ version }: HistoryRow) => (version === null ? 30 : 66);

/** The versions, newest first, by day. */
function VersionList({ versions, picked, onPick }: VersionListProps) {
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
          onToggle={({ day }) => setFolded((days) => toggledIn(days, day))}
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

/** A version in the list: its picture, time, steps, name and verdict. */
function VersionLine({ version, now }: { readonly version: Version; readonly now: number }) {
  const editor = useEditor();
  const level = useLevel();
  const theme = usePageTheme();
  const { folder: terms } = usePageTerms();
  const by = useMemo(() => ({ theme, terms }), [theme, terms]);
  const pictures = picturesOf(editor);
  const key = versionKey(version, by);
  const picture = useStore(pictures.store, ({ byKey }) => byKey.get(key)) ?? null;
  // biome-ignore lint/correctness/useExhaustiveDependencies: a renamed version looks the same
  useEffect(() => {
    wantPicture(editor, level, version, by);
    return () => pictures.drop(key);
  }, [editor, level, pictures, key, by]);
  const steps = stepsInWords(version);
  // the first line has the most telling of the three, the second the next
  const [title, about] = [version.name, version.changes, steps].filter((words) => words !== null && words !== '');
  return (
    <>
      <span className="levels__picture">{picture?.url != null && <img src={picture.url} alt="" draggable={false} />}</span>
      <span className="history__text" title={[version.changes, steps].filter((words) => words !== '').join(' – ')}>
        <span className="history__line">
          {version.name !== null && <Bookmark size={12} aria-label="named" className="history__mark" />}
          {version.by === 'other' && <HardDrive size={12} aria-label="by another program" className="history__mark" />}
          <span className={version.name === null ? 'history__steps' : 'history__name'}>{title}</span>
        </span>
        {about !== undefined && <span className="history__line history__line--quiet history__about-line">{about}</span>}
        <span className="history__line history__line--quiet">
          <span className="numbers">{clockTime(version.time)}</span>
          <span>{agoInWords(version.time, now)}</span>
          {picture !== null && <VerdictSign verdict={picture.verdict} />}
        </span>
      </span>
    </>
  );
}

/** How a version is drawn and judged. */
interface DrawnBy {
  readonly theme: 'dark' | 'light';
  readonly terms: Terms;
}

/** px: twice the shown size, for high-density screens */
const WIDTH = 128;

/** Versions with the same text look alike. */
const versionKey = ({ check }: Version, by: DrawnBy): string => pictureKey(`version ${check}`, { ...by, width: WIDTH });

/** Asks for the picture of a version of an open level unless there is one. */
function wantPicture(editor: Editor, level: OpenLevel, version: Version, by: DrawnBy): void {
  const text = () => level.opened.versions.text(version);
  picturesOf(editor).want(versionKey(version, by), { ...by, width: WIDTH, text });
}

import { ArrowDown, ArrowUp, FolderOpen, Heading, ListX } from 'lucide-react';
import { type KeyboardEvent, useEffect, useMemo, useRef, useState } from 'react';
import { useStore } from 'zustand';
import { addChapter, moveEntries, removeEntries, setChapter } from '../../../check/pack/index.ts';
import type { Terms } from '../../../engine/index.ts';
import type { LevelEntry, PackFile, Problem } from '../../../schema/index.ts';
import { useEditor, usePageTerms, usePageTheme, useSession, useTouch } from '../../core/context/index.ts';
import { type FolderPack, folderPackIn } from '../../core/files/index.ts';
import { editPack, factsOf, listHistoryOf, openListed, thumbnailKey, thumbnailsOf } from '../../core/levels/index.ts';
import { TextDialog } from '../../core/panel/index.ts';
import { Button } from '../../core/ui/index.ts';
import { countOf, type Move, moveByKey, moveInWords, placesOf } from './card-order.ts';
import { gradeOf, gradesOf } from './grades.ts';
import { PackCards, type Selection, useVerdictOf } from './PackCards.tsx';
import { PackCurve } from './PackCurve.tsx';
import { PackFilter, PackHead, PackProblems } from './PackHead.tsx';
import { type Card, type Filter, isFiltered, modelOf, NO_FILTER, type PackModel, passes } from './pack-model.ts';

/** All levels of the folder as cards in the order in which they are played; fills the page. */
export function PackView() {
  return useSession(({ view }) => view === 'pack') ? <Pack /> : null;
}

function Pack() {
  const editor = useEditor();
  const { session, workspace } = editor;
  const { model, pack, levels, terms } = usePack();
  const [filter, setFilter] = useState<Filter>(NO_FILTER);
  const [selection, setSelection] = useState<Selection>(() => {
    const opened = workspace.store.getState().opened?.id() ?? null;
    return { keys: new Set(opened === null ? [] : [opened]), active: opened };
  });
  const [said, setSaid] = useState('');
  const [asText, setAsText] = useState<LevelEntry | null>(null);
  const focus = useRef<string | null>(selection.active);
  const view = useRef<HTMLDivElement>(null);
  const verdictOf = useVerdictOf(terms);
  const isTouch = useTouch();

  // keys work in the view at once, also where no level is open
  useEffect(() => {
    if (!view.current?.contains(document.activeElement)) view.current?.focus();
  }, []);

  const close = () => session.setState({ view: 'level' });
  // a level that is opened in another way, such as by its name, is shown
  useEffect(
    () =>
      editor.open.subscribe((now, before) => {
        if (now !== null && now.opened !== before?.opened) session.setState({ view: 'level' });
      }),
    [editor, session],
  );
  const shown = model.cards.filter((card) => passes(card, verdictOf(card), filter));
  const filtered = isFiltered(filter);
  const isWritable = pack.kind === 'none' || (pack.kind === 'valid' && pack.readOnly === null);
  const canMove = isWritable && !filtered;
  const canEdit = pack.kind === 'valid' && pack.readOnly === null;
  const count = countOf(model.chapters);
  const chosen = shown.filter(({ key }) => selection.keys.has(key));
  const ids = levels.map(({ id }) => id);

  const edit = (label: string, change: (now: PackFile) => PackFile) => editPack(editor, label, change);
  const move = async ({ moved, before }: Move) => {
    focus.current = selection.active;
    const label = moveInWords(model.cards, moved);
    if (!(await edit(label, (now) => moveEntries(now, ids, moved, before)))) return;
    setSaid(label.replace(/^Move/, 'Moved'));
  };
  const onMoveKey = (key: string): boolean => {
    if (!canMove) {
      setSaid(filtered ? 'Levels can be moved once all are shown: clear the filter.' : 'The order can not be changed here.');
      return true;
    }
    const wanted = moveByKey(placesOf(shown, selection.keys), key, count);
    if (wanted !== null) void move(wanted);
    return true;
  };
  const open = ({ entry }: Card) => {
    if (entry === null) return;
    if (entry.status !== 'valid') setAsText(entry);
    else {
      close();
      void openListed(editor, entry.id);
    }
  };
  const goTo = (card: Card) => {
    if (filtered) setFilter(NO_FILTER);
    focus.current = card.key;
    setSelection({ keys: new Set([card.key]), active: card.key });
  };
  const goToProblem = ({ pointer }: Problem) => {
    const place = Number(/^\/levels\/(\d+)/.exec(pointer)?.[1] ?? Number.NaN);
    const card =
      model.cards.find((one) => one.place === place) ??
      model.cards.find((one) => one.place > place) ??
      model.cards.find(({ isListed }) => !isListed) ??
      model.cards[0];
    const heading = view.current?.querySelector<HTMLElement>(`[data-chapter][data-place="${place}"] input`);
    if (heading != null) heading.focus();
    else if (card !== undefined) goTo(card);
  };
  const newChapter = async () => {
    const [first] = chosen;
    if (first === undefined) return;
    if (!(await edit('New chapter', (now) => addChapter(now, first.place, 'New chapter')))) return;
    requestAnimationFrame(() => {
      const field = view.current?.querySelector<HTMLInputElement>(`[data-chapter][data-place="${first.place}"] input`);
      field?.focus();
      field?.select();
    });
  };
  const takeOut = async () => {
    const places = chosen.filter(({ isListed }) => isListed).map(({ place }) => place);
    const label = moveInWords(model.cards, places).replace(/^Move/, 'Take out');
    if (await edit(label, (now) => removeEntries(now, places))) setSaid(label.replace(/^Take/, 'Took'));
  };
  const onKeyDown = (event: KeyboardEvent<HTMLDivElement>) => {
    if (event.defaultPrevented) return;
    const mod = event.ctrlKey || event.metaKey;
    const key = event.key.toLowerCase();
    const inText = event.target instanceof HTMLInputElement;
    const history = listHistoryOf(editor);
    const { undoesList, redoesList } = history.store.getState();
    if (event.key === 'Escape') close();
    else if (mod && !inText && key === 'z' && !event.shiftKey && undoesList) history.undo();
    else if (mod && !inText && (key === 'y' || (key === 'z' && event.shiftKey)) && redoesList) history.redo();
    else return;
    event.preventDefault();
    focus.current = selection.active;
  };

  return (
    <div ref={view} className="pack" role="dialog" aria-modal aria-labelledby="pack-title" tabIndex={-1} onKeyDown={onKeyDown}>
      <PackHead {...{ model, pack, terms, canEdit }} onClose={close} />
      <div className="pack__scroll">
        <p className="pack__note pack__about">{aboutPack(pack.kind, pack.kind === 'none' ? '' : pack.file)}</p>
        {pack.kind === 'unreadable' && (
          <p className="pack__note" role="alert">
            {pack.file}: {pack.why}.
          </p>
        )}
        <PackProblems
          file={pack.kind === 'none' ? '' : pack.file}
          problems={model.problems}
          onGo={pack.kind === 'valid' ? goToProblem : null}
        />
        <PackCurve cards={model.cards} onGo={goTo} />
        <div className="pack__tools">
          <PackFilter
            filter={filter}
            cards={model.cards}
            shown={shown.length}
            verdicts={[...new Set(model.cards.map(verdictOf))].sort()}
            onChange={setFilter}
          />
          <div className="pack__actions" role="toolbar" aria-label="Selected levels">
            <span className="pack__note numbers">{chosen.length === 0 ? 'none selected' : `${chosen.length} selected`}</span>
            <Button
              hint="Open the selected level"
              shortcut="Enter"
              icon={<FolderOpen size={15} />}
              disabled={chosen.length !== 1 || chosen[0].entry === null}
              onClick={() => open(chosen[0])}
            />
            <Button
              hint="Move earlier"
              shortcut="Alt ←"
              icon={<ArrowUp size={15} />}
              disabled={!canMove || chosen.length === 0}
              onClick={() => onMoveKey('ArrowUp')}
            />
            <Button
              hint="Move later"
              shortcut="Alt →"
              icon={<ArrowDown size={15} />}
              disabled={!canMove || chosen.length === 0}
              onClick={() => onMoveKey('ArrowDown')}
            />
            <Button
              hint="New chapter before the first selected level"
              icon={<Heading size={15} />}
              disabled={!canMove || !chosen.some(({ isListed }) => isListed)}
              onClick={() => void newChapter()}
            >
              Chapter
            </Button>
            <Button
              hint="Take the selected levels out of the list; their files stay"
              icon={<ListX size={15} />}
              disabled={!canEdit || !chosen.some(({ isListed }) => isListed)}
              onClick={() => void takeOut()}
            />
          </div>
        </div>
        <p className="unseen" role="status">
          {said}
        </p>
        {model.cards.length === 0 ? (
          <p className="pack__empty">There are no levels in this folder yet.</p>
        ) : shown.length === 0 ? (
          <p className="pack__empty">No level passes the filter.</p>
        ) : (
          <PackCards
            {...{ chapters: model.chapters, shown, terms, canMove, canEdit, selection, focus, onMoveKey }}
            isFiltered={filtered}
            onSelect={setSelection}
            onOpen={open}
            onDrop={(keys, before) => void move({ moved: placesOf(model.cards, keys), before })}
            onRenameChapter={(place, name) => void edit('Rename chapter', (now) => setChapter(now, place, name))}
            onRemoveChapter={(place) => void edit('Remove chapter', (now) => setChapter(now, place, null))}
          />
        )}
        <p className="pack__note pack__keys">
          {isTouch
            ? 'Drag a level by its grip, or move the selected one with the arrows above. A double tap opens it.'
            : 'Drag levels, or move them with Alt and an arrow. Space or Ctrl + click selects several. Enter or a double-click opens a level.'}
        </p>
      </div>
      {asText !== null && <TextDialog id={asText.id} fromDisk onClose={() => setAsText(null)} />}
    </div>
  );
}

function aboutPack(kind: 'none' | 'valid' | 'invalid' | 'unreadable', file: string): string {
  if (kind === 'none') return 'The order is that of the file names: there is no pack.json. Moving a level here makes one.';
  if (kind === 'valid') return `The order in which the levels are played, from ${file}.`;
  return `${file} gives no order until it is mended; the order is that of the file names.`;
}

const NO_LEVELS: readonly LevelEntry[] = [];

/** What the view of the pack is made of. */
interface ShownPack {
  readonly model: PackModel;
  readonly pack: FolderPack;
  readonly levels: readonly LevelEntry[];
  readonly terms: Terms;
}

/** The pack of the folder; its levels are looked at while this is mounted. */
function usePack(): ShownPack {
  const editor = useEditor();
  const { workspace } = editor;
  const theme = usePageTheme();
  const { folder: terms } = usePageTerms();
  const levels = useStore(workspace.store, ({ list }) => list?.levels) ?? NO_LEVELS;
  const folder = useStore(workspace.store, ({ list }) => list?.folder.id) ?? '';
  const pack = useStore(workspace.store, folderPackIn);
  const thumbnails = thumbnailsOf(editor);
  const grades = gradesOf(editor);
  const facts = useStore(thumbnails.store, (made) => made.facts);
  const graded = useStore(grades.store, (state) => state.byKey);

  useEffect(() => {
    const valid = levels.filter(({ status }) => status === 'valid');
    // the last one that is wanted is made first
    for (const entry of valid.toReversed()) thumbnails.want(entry, theme, terms);
    return () => {
      for (const entry of valid) thumbnails.drop(thumbnailKey(entry, theme, terms) ?? '');
    };
  }, [thumbnails, levels, theme, terms]);
  // while nobody looks, nothing is measured
  useEffect(() => grades.stop, [grades]);

  const model = useMemo(() => {
    void facts;
    void graded;
    return modelOf({
      levels,
      pack,
      factsOf: (entry) => factsOf(thumbnails.store.getState(), entry, terms),
      gradeOf: (entry) => gradeOf(grades.store.getState(), folder, entry, terms),
    });
  }, [levels, pack, facts, graded, folder, terms, thumbnails, grades]);
  return { model, pack, levels, terms };
}

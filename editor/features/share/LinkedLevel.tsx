import { useEffect, useMemo, useState } from 'react';
import { enteringFolder, formatLevel, KINDS, kindOfList, type LevelFile, OBJECT_LISTS } from '../../../schema/index.ts';
import { useQuestion } from '../../core/ask/index.ts';
import { useEditor, useFolderTerms, usePageTerms, usePageTheme } from '../../core/context/index.ts';
import { placesOf } from '../../core/document/index.ts';
import { slugOf } from '../../core/exchange/index.ts';
import { addLevels } from '../../core/levels/index.ts';
import { pictureQuestion, urlOf } from '../../core/pictures/index.ts';
import { Button } from '../../core/ui/index.ts';

/** What a level from a link contains, in words, before it is added. */
export interface LinkSurvey {
  /** `3 asteroids, 1 run with 4 holds` */
  readonly counts: string;
  /** size of its file */
  readonly size: string;
  readonly warnings: readonly string[];
}

/** From these numbers on, the page may become slow. */
const MANY = { objects: 2000, aliens: 200, runs: 50, holds: 2000 } as const;
/** Objects farther out than this are probably a mistake, px. */
const FAR = 1e6;

const count = (number: number, [one, many]: readonly [string, string]): string =>
  `${number.toLocaleString('en')} ${number === 1 ? one : many}`;

/** @param text the text of the level file */
export function surveyLink(file: LevelFile, text: string): LinkSurvey {
  const lists = OBJECT_LISTS.map((list) => {
    const kind = kindOfList(list);
    const objects: readonly { x: number; y: number }[] = file[list] ?? [];
    return { kind, objects };
  });
  const runs = file.runs ?? [];
  const holds = runs.reduce((sum, run) => sum + run.holds.length, 0);
  const rules = Object.keys(file.rules ?? {}).length;
  const all = lists.reduce((sum, { objects }) => sum + objects.length, 0);
  const aliens = file.aliens?.length ?? 0;
  const places = [
    file.astronaut,
    file.blackHole,
    ...lists.flatMap(({ kind, objects }) => objects.flatMap((object) => placesOf({ kind, object }))),
  ];
  const isFar = places.some(({ x, y }) => Math.max(Math.abs(x), Math.abs(y)) > FAR);
  const counts = [
    ...lists
      .filter(({ objects }) => objects.length > 0)
      .map(({ kind, objects }) => count(objects.length, [KINDS[kind].one, KINDS[kind].many])),
    ...(rules === 0 ? [] : [count(rules, ['changed rule', 'changed rules'])]),
    runs.length === 0 ? 'no run' : `${count(runs.length, ['run', 'runs'])} with ${count(holds, ['hold', 'holds'])}`,
  ];
  const warnings = [
    ...(all > MANY.objects || aliens > MANY.aliens ? ['It has very many objects: the page may be slow while it is open.'] : []),
    ...(runs.length > MANY.runs || holds > MANY.holds
      ? ['It has very many runs or holds: the page may be slow while it is open.']
      : []),
    ...(isFar ? [`Some objects are more than ${FAR.toLocaleString('en')} px from the origin.`] : []),
  ];
  const kB = new TextEncoder().encode(text).length / 1000;
  return { counts: counts.join(', '), size: `${kB < 10 ? kB.toFixed(1) : Math.round(kB).toLocaleString('en')} kB`, warnings };
}

/** width of the picture, px */
const WIDTH = 420;

/** A picture and the verdict of the level, made by a worker so that a costly level does not block the page. */
function usePicture(text: string): { readonly url: string | null; readonly words: string } {
  const { desk } = useEditor();
  const theme = usePageTheme();
  const { folder } = usePageTerms();
  // Rules of a folder do not apply to a level from a link.
  const drawing = useMemo(() => ({ text, terms: { ...folder, rules: {} }, width: WIDTH, theme }), [text, folder, theme]);
  const { phase, answer } = useQuestion(pictureQuestion, desk, drawing) ?? { phase: 'idle', answer: null };
  const [url, setUrl] = useState<string | null>(null);
  useEffect(() => {
    if (answer === null) return;
    const made = urlOf(answer.svg);
    setUrl(made);
    return () => {
      setUrl(null);
      if (made !== null) URL.revokeObjectURL(made);
    };
  }, [answer]);
  if (answer !== null) return { url, words: answer.verdict };
  return { url: null, words: phase === 'failed' ? 'unknown: it takes too long to simulate' : 'checking…' };
}

interface LinkedLevelProps {
  readonly file: LevelFile;
  readonly onClose: () => void;
}

/** What a level from a link is, and whether to add it. */
export function LinkedLevel({ file, onClose }: LinkedLevelProps) {
  const editor = useEditor();
  const text = useMemo(() => formatLevel(file), [file]);
  const { counts, size, warnings } = useMemo(() => surveyLink(file, text), [file, text]);
  const { url, words } = usePicture(text);
  const folder = useFolderTerms();
  const [busy, setBusy] = useState(false);
  const add = async () => {
    setBusy(true);
    const kept = enteringFolder(file, folder.rules);
    const added = await addLevels(editor, '', [{ stem: slugOf(file.name), file: kept }]);
    setBusy(false);
    if (added.length === 0) return;
    onClose();
    const ruled = kept === file ? '' : ` It keeps its own rules instead of those of ${folder.file}.`;
    editor.notices.show('info', `"${file.name}" was added from the link.${ruled}`, { topic: 'link' });
  };
  return (
    <div className="form link">
      <p className="link__name">{file.name}</p>
      {file.description !== undefined && <p className="link__text">{file.description}</p>}
      {url !== null && <img className="link__picture" src={url} alt="" />}
      <dl className="link__facts">
        <dt>Contents</dt>
        <dd>{counts}</dd>
        <dt>Size</dt>
        <dd>{size}</dd>
        <dt>Verdict</dt>
        <dd>{words}</dd>
      </dl>
      {warnings.length > 0 && (
        <ul className="link__warnings" aria-label="Warnings">
          {warnings.map((warning) => (
            <li key={warning}>{warning}</li>
          ))}
        </ul>
      )}
      <div className="form__buttons">
        <Button hint="Close without adding the level" look="outlined" onClick={onClose}>
          Don't add
        </Button>
        <Button hint="Add it as a new level and open it" look="main" disabled={busy} onClick={() => void add()}>
          Add level
        </Button>
      </div>
    </div>
  );
}

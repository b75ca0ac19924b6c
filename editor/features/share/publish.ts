import { chaptersOf, packedLevel } from '../../../check/pack/index.ts';
import { plural } from '../../../check/words/index.ts';
import type { Terms } from '../../../engine/index.ts';
import { type LevelEntry, type LevelFile, levelsOfPack, type RefusedLevel } from '../../../schema/index.ts';
import { askOnce, type Desk } from '../../core/ask/index.ts';
import type { Editor } from '../../core/context/index.ts';
import { downloadFile, fetchGame, singlePage, slugOf } from '../../core/exchange/index.ts';
import { errorInWords, folderPackIn, type LevelStorage, problemInWords, readText } from '../../core/files/index.ts';
import { pictureQuestion } from '../../core/pictures/index.ts';
import { accuracyNameOf } from '../../workers/index.ts';

/** What is published, and as what. */
export type Target = 'folder' | 'levelFolder' | 'file' | 'levelFile';

export interface PublishWish {
  readonly target: Target;
  /** The name of the folder. */
  readonly site: string;
  readonly title: string;
  readonly withRuns: boolean;
  /** Whether to publish levels that are not known to be completable. */
  readonly force: boolean;
  readonly onProgress: (checked: number, all: number) => void;
}

/** What became of it. */
export type Published =
  | { readonly kind: 'done'; readonly message: string }
  /** `reasons`: what must be corrected first, one sentence or two each */
  | { readonly kind: 'failed'; readonly message: string; readonly reasons: readonly string[] }
  | { readonly kind: 'refused'; readonly levels: readonly RefusedLevel[] };

const megabytes = (bytes: number): string => `${(bytes / 1e6).toFixed(1)} MB`;

/** Publishes levels. Never rejects. */
export async function publish(editor: Editor, wish: PublishWish): Promise<Published> {
  try {
    // what is published is what is saved
    const { opened } = editor.workspace.store.getState();
    if (opened !== null && !(await opened.saver.flush()))
      throw new Error(`the latest changes to “${opened.id()}” are not saved yet, and would be missing`);
    return await (wish.target === 'folder' || wish.target === 'levelFolder' ? intoFolder : asFile)(editor, wish);
  } catch (error) {
    const message = `The levels could not be published: ${error instanceof Error ? error.message : error}.`;
    return { kind: 'failed', message, reasons: [] };
  }
}

async function intoFolder({ workspace }: Editor, { target, site, title, withRuns, force }: PublishWish): Promise<Published> {
  const { storage, store } = workspace;
  const level = target === 'folder' ? null : (store.getState().opened?.id() ?? null);
  if (storage.publish === null) throw new Error('this page has no folders');
  const answer = await storage.publish({ site, level, title, withRuns, force });
  if (answer.ok) {
    const { site: path, levels, bytes } = answer.value;
    const message = `Published ${plural(levels, 'level')} in ${path} (${megabytes(bytes)}). Open index.html there, or put the folder on any web server.`;
    return { kind: 'done', message };
  }
  if (answer.error.levels !== undefined) return { kind: 'refused', levels: answer.error.levels };
  const { files = [] } = answer.error;
  const reasons = files.flatMap(({ file, problems }) => problems.map((problem) => problemInWords(file, problem)));
  return { kind: 'failed', message: errorInWords(answer.error), reasons };
}

async function asFile(editor: Editor, { target, title, withRuns, force, onProgress }: PublishWish): Promise<Published> {
  const { workspace, desk } = editor;
  const { list, opened } = workspace.store.getState();
  const pack = folderPackIn({ list });
  if (target === 'file' && (pack.kind === 'invalid' || pack.kind === 'unreadable'))
    throw new Error(`${pack.file} is not valid, so the order of the levels is not known`);
  const order = target === 'file' && pack.kind === 'valid' ? pack.reading.pack : null;
  const listed = order === null ? null : new Set(levelsOfPack(order));
  const entries = (list?.levels ?? []).filter(({ id }) => (target === 'file' ? listed?.has(id) !== false : id === opened?.id()));
  if (entries.length === 0) throw new Error(order === null ? 'there is no level' : 'pack.json lists no level');
  const { folder: terms } = editor.terms.getState();
  const { levels, refused } = await collectLevels(entries, {
    storage: workspace.storage,
    desk,
    terms,
    withRuns,
    onProgress: (checked) => onProgress(checked, entries.length),
  });
  if (refused.some(({ verdict }) => verdict === 'invalid') || (refused.length > 0 && !force))
    return { kind: 'refused', levels: refused };
  const game = await fetchGame(new URL('game/', document.baseURI).href);
  const chapters = order === null ? null : chaptersOf(order);
  const inChapters = levels.map((level) => {
    const chapter = chapters?.get(level.id);
    return chapter === undefined ? level : { ...level, chapter };
  });
  const blob = new Blob(
    [singlePage(game, { title, accuracy: accuracyNameOf(terms), maxTime: terms.maxTime, levels: inChapters })],
    {
      type: 'text/html',
    },
  );
  const name = `${slugOf(title)}.html`;
  downloadFile({ name, blob });
  const message = `Downloaded ${name}: ${plural(levels.length, 'level')}, ${megabytes(blob.size)}. Open it in a browser, send it, or put it on any web server.`;
  return { kind: 'done', message };
}

/** Levels for a page, and those that are not known to be completable. */
interface CollectedLevels {
  readonly levels: readonly { readonly id: string; readonly level: unknown }[];
  readonly refused: readonly RefusedLevel[];
}

interface Collecting {
  readonly storage: LevelStorage;
  readonly desk: Desk;
  /** Those of the folder. */
  readonly terms: Terms;
  readonly withRuns: boolean;
  /** Called with the number of levels that are done. */
  readonly onProgress: (done: number) => void;
}

const WORDS: Readonly<Record<RefusedLevel['verdict'], string>> = {
  completable: '',
  broken: 'none of its runs completes it',
  unproven: 'no run shows that it can be completed',
  impossible: 'it is proved that nobody can complete it',
  invalid: 'the file is not a valid level',
  crashed: 'its check failed',
};

/**
 * Reads levels and gives each the verdict of `gq check`.
 * @throws (rejects) in words if one can't be read
 */
async function collectLevels(entries: readonly LevelEntry[], options: Collecting): Promise<CollectedLevels> {
  const { storage, desk, terms, withRuns, onProgress } = options;
  const levels: { id: string; level: unknown }[] = [];
  const refused: RefusedLevel[] = [];
  for (const [i, { id, name }] of entries.entries()) {
    onProgress(i);
    const answer = await storage.read(id);
    if (!answer.ok) throw new Error(errorInWords(answer.error));
    const reading = answer.value.text === null ? null : readText(answer.value.text);
    const file: LevelFile | null = reading?.ok ? reading.file : null;
    const refuse = (verdict: RefusedLevel['verdict'], message = WORDS[verdict]) =>
      refused.push({ id, name: name ?? id, verdict, message });
    if (file === null || answer.value.text === null) {
      refuse('invalid', answer.value.problems[0]?.message);
      continue;
    }
    const looks = { width: 16, theme: 'dark' } as const;
    const drawn = await askOnce(pictureQuestion, desk, { text: answer.value.text, terms, ...looks }).end;
    const verdict = drawn.answer?.verdict ?? 'unproven';
    if (verdict !== 'completable') refuse(verdict);
    levels.push({ id, level: packedLevel(file, { rules: terms.rules, withRuns, found: null }) });
  }
  onProgress(entries.length);
  return { levels, refused };
}

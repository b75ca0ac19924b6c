import { plural } from '../../../check/words/index.ts';
import { decodePlay, ENGINE_ID, levelHash, type Play } from '../../../game/index.ts';
import { type LevelEntry, readLevel } from '../../../schema/index.ts';
import { jobs } from '../../workers/index.ts';
import { askOnce, onDemand } from '../ask/index.ts';
import type { Editor, OpenLevel } from '../context/index.ts';
import { allLevels, folderTermsIn } from '../files/index.ts';
import { keptWith } from '../kept/index.ts';
import { openListed } from '../levels/index.ts';
import { type GivenPlay, hashNow, type OpenedPlay, type RefusedFile, readPlayFiles, shelfOf } from '../shelf/index.ts';
import { deskOf, inTurn } from './play-files.ts';

/** Topics of notices. */
const OPENED = { topic: 'plays' } as const;
const REFUSED = { topic: 'plays-refused' } as const;
const OTHER_LEVEL = 'plays-other-level';

/** How plays are opened. */
export interface OpenOptions {
  /** What was refused before. */
  readonly refused?: readonly RefusedFile[];
  /** Whether the level of the plays is opened, too, as for a link; otherwise it is offered. */
  readonly withLevel?: boolean;
}

/** Reads files of plays and opens them. */
export const openPlayFiles = (editor: Editor, files: readonly File[]): Promise<void> =>
  inTurn(editor, async () => {
    let isOver = false;
    const cancel = () => {
      isOver = true;
    };
    deskOf(editor).reading.setState({ what: 'files', done: 0, of: files.length, cancel }, true);
    const { plays, refused } = await readPlayFiles(files, () => isOver);
    if (!isOver) await take(editor, plays, { refused });
  });

/**
 * Opens plays: those of the open level become attempts of it. For those of other levels of the folder, their level is offered
 * by name; others are refused.
 */
export const openPlays = (editor: Editor, given: readonly GivenPlay[], options: OpenOptions = {}): Promise<void> =>
  inTurn(editor, () => take(editor, given, options));

async function take(
  editor: Editor,
  given: readonly GivenPlay[],
  { refused = [], withLevel = false }: OpenOptions,
): Promise<void> {
  const { open, notices } = editor;
  for (const topic of [OPENED.topic, REFUSED.topic, OTHER_LEVEL]) notices.clear(topic);
  const groups = groupPlays(given);
  const level = open.getState();
  const hash = level === null ? null : hashNow(level);
  const own = hash === null ? undefined : groups.byLevel.get(hash);
  if (level !== null && hash !== null && own !== undefined) await addPlays(editor, level, hash, own);
  const others = new Map([...groups.byLevel].filter(([key]) => key !== hash));
  const unknown = await offerOthers(editor, others, withLevel || level === null);
  const all = [...refused, ...groups.refused, ...unknown];
  if (all.length === 0) return;
  const title = `${plural(all.length, 'file')} of ${given.length + refused.length} ${all.length === 1 ? 'was' : 'were'} not opened.`;
  const text = refusedInWords(all);
  notices.show('error', given.length + refused.length > 1 ? `${title}\n${text}` : text, REFUSED);
}

/** Whether plays are what they claim, and what they teach. */
export const playsQuestion = onDemand(jobs.plays);

/** Verifies plays of the open level and adds them to its shelf. */
async function addPlays(editor: Editor, level: OpenLevel, hash: string, plays: readonly ReadPlay[]): Promise<void> {
  const { notices, desk, commands } = editor;
  const { reading } = deskOf(editor);
  const shelf = shelfOf(level);
  const { plays: before, statistics, of } = shelf.store.getState();
  const isOutdated = of !== null && of.hash !== hash;
  commands.run('panel.attempts');
  const fresh = shelf.fresh(plays);
  if (fresh.length === 0) {
    notices.show('info', plays.length === 1 ? `${plays[0].name} is open already.` : 'These plays are open already.', OPENED);
    return;
  }
  const tell = (done: number) => reading.setState({ what: 'plays', done, of: fresh.length, cancel: () => asking.stop() }, true);
  const { level: played, terms } = level.proof.proof();
  const about = {
    level: played,
    terms,
    plays: fresh.map(({ bytes }) => bytes),
    known: isOutdated || statistics === null ? [] : statistics.all,
    first: isOutdated ? 0 : before.length,
  };
  const asking = askOnce(playsQuestion, desk, about, ({ phase, progress }) => {
    if (phase === 'asking' && progress !== null) tell(progress.done);
  });
  tell(0);
  const { answer, message } = await asking.end;
  reading.setState(null, true);
  if (message !== null) notices.show('error', `The plays can’t be verified: ${message}.`, OPENED);
  if (answer === null) return;
  const opened = fresh.map(({ name, ...play }, i) => ({ ...play, source: name, ...answer.plays[i] }));
  const added = shelf.add(opened, answer.statistics, { level: played, hash });
  if (added.length === 1) shelf.select([added[0].key]);
  notices.show('info', openedInWords(added, plays.length - fresh.length, isOutdated), OPENED);
}

function openedInWords(added: readonly OpenedPlay[], known: number, isOutdated: boolean): string {
  const differ = added.filter(({ verdict }) => verdict !== 'ok');
  const won = added.filter(({ replayed }) => replayed?.outcome === 'completed').length;
  const parts = [
    added.length === 1 ? `${added[0].source} was opened.` : `${added.length} plays were opened: ${won} complete the level.`,
  ];
  if (differ.length > 0) parts.push(`${plural(differ.length, 'play')} ${differ.length === 1 ? 'is' : 'are'} not what it claims.`);
  if (known > 0) parts.push(`${known} ${known === 1 ? 'was' : 'were'} open already.`);
  if (isOutdated) parts.push('The plays of the level before its change were closed.');
  return parts.join(' ');
}

/** Plays whose files are named in a message. */
const NAMED = 3;

function namesOf(plays: readonly ReadPlay[]): string {
  const names = plays.slice(0, NAMED).map(({ name }) => name);
  return plays.length > NAMED ? `${names.join(', ')} and ${plays.length - NAMED} more` : names.join(', ');
}

/**
 * Finds the levels of the folder that plays belong to, and offers to open them.
 * @param opens whether the level is opened at once if it is the only one
 * @returns the plays of no level of the folder
 */
async function offerOthers(
  editor: Editor,
  others: ReadonlyMap<string, readonly ReadPlay[]>,
  opens: boolean,
): Promise<RefusedFile[]> {
  if (others.size === 0) return [];
  const { notices } = editor;
  const entries = await levelsByHash(editor, new Set(others.keys()));
  const found = [...others].flatMap(([hash, plays]) => {
    const entry = entries.get(hash);
    return entry === undefined ? [] : [{ id: entry.id, name: entry.name ?? entry.id, plays }];
  });
  const goTo = async ({ id, plays }: (typeof found)[number]): Promise<void> => {
    await openListed(editor, id);
    const opened = editor.open.getState();
    // it is asked about first, or another one was opened in the meantime
    if (opened === null || opened.opened.id() !== id) return;
    const hash = hashNow(opened);
    if (plays[0].play.level === hash) await addPlays(editor, opened, hash, plays);
    else notices.show('warning', `“${id}” has changed since it was listed: the plays are of the version before.`, OPENED);
  };
  if (opens && found.length === 1) await goTo(found[0]);
  else if (found.length > 0) {
    const lines = found.slice(0, NAMED).map(({ name, plays }) => {
      const are = plays.length === 1 ? 'is a play' : 'are plays';
      return `${namesOf(plays)} ${are} of another level of this folder, “${name}”.`;
    });
    if (found.length > NAMED) lines.push(`The other files are plays of ${plural(found.length - NAMED, 'more level')}.`);
    const actions = found.slice(0, NAMED).map((one) => ({
      title: `Open ${one.name}`,
      run: () => void inTurn(editor, () => goTo(one)),
    }));
    notices.show('warning', lines.join('\n'), { topic: OTHER_LEVEL, actions });
  }
  return [...others].flatMap(([hash, plays]) =>
    entries.has(hash) ? [] : plays.map(({ name }) => ({ name, reason: staleInWords(editor, hash) })),
  );
}

/** Why a play belongs to no level here. */
function staleInWords({ open }: Editor, hash: string): string {
  const level = open.getState();
  const found = `found one of level ${hash.slice(0, 8)}…, which no level of this folder is now`;
  const here = level === null ? 'a level of this folder' : `the open level, “${level.document.file().name}”`;
  return `stale-level: expected a play of ${here}, ${found}. Open the version of the level that it was played on`;
}

/** A play that can be read, by an engine that this page has. */
interface ReadPlay extends GivenPlay {
  readonly play: Play;
}

/** Plays by the hash of their level. */
interface GroupedPlays {
  readonly byLevel: ReadonlyMap<string, readonly ReadPlay[]>;
  readonly refused: readonly RefusedFile[];
}

/** Reads plays and groups them by level. Those that can't be read, or were played with another engine, are refused. */
export function groupPlays(given: readonly GivenPlay[]): GroupedPlays {
  const byLevel = new Map<string, ReadPlay[]>();
  const refused: RefusedFile[] = [];
  for (const { name, bytes } of given) {
    const decoded = decodePlay(bytes);
    if (!decoded.ok) {
      refused.push({ name, reason: `${decoded.verdict}: ${decoded.message}` });
      continue;
    }
    const { play } = decoded;
    if (play.engine !== ENGINE_ID) {
      refused.push({ name, reason: `unknown-engine: expected a play of engine ${ENGINE_ID}, found one of ${play.engine}` });
      continue;
    }
    const group = byLevel.get(play.level);
    if (group === undefined) byLevel.set(play.level, [{ name, bytes, play }]);
    else group.push({ name, bytes, play });
  }
  return { byLevel, refused };
}

/** Lines of a message. */
const LINES = 4;

/** What was refused, a line each; what there is no room for is counted. */
export function refusedInWords(refused: readonly RefusedFile[]): string {
  const lines = refused.slice(0, LINES).map(({ name, reason }) => `${name}: ${reason}.`);
  const rest = refused.length - lines.length;
  if (rest > 0) lines.push(`${rest} more ${rest === 1 ? 'was' : 'were'} refused as well.`);
  return lines.join('\n');
}

/** The hashes of levels that were read, by file, version and rules. */
const hashesOf = keptWith<Editor, Map<string, string | null>>(() => new Map());

async function hashOf(editor: Editor, { id, etag }: LevelEntry): Promise<string | null> {
  const { storage, store } = editor.workspace;
  const { rules } = folderTermsIn(store.getState());
  const hashes = hashesOf(editor);
  const key = JSON.stringify([id, etag, rules]);
  const before = hashes.get(key);
  if (before !== undefined) return before;
  const answer = await storage.read(id);
  const reading = answer.ok ? readLevel(answer.value.text ?? '', { rules }) : null;
  const hash = reading?.ok === true ? levelHash(reading.level) : null;
  if (answer.ok) hashes.set(key, hash);
  return hash;
}

/** Finds levels of the folder by their hashes. It reads their files, until all are found. */
export async function levelsByHash(editor: Editor, wanted: ReadonlySet<string>): Promise<ReadonlyMap<string, LevelEntry>> {
  const found = new Map<string, LevelEntry>();
  for (const entry of await allLevels(editor.workspace)) {
    if (found.size === wanted.size) break;
    if (entry.status !== 'valid') continue;
    const hash = await hashOf(editor, entry);
    if (hash !== null && wanted.has(hash) && !found.has(hash)) found.set(hash, entry);
  }
  return found;
}

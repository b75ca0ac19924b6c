import { type FolderTerms, RULE_NAMES, RULES } from '../../schema/index.ts';
import type { Editor } from '../core/context/index.ts';
import { errorInWords, folderTermsIn, type LevelStorage, type Link, problemsInWords } from '../core/files/index.ts';
import { ruleLabel } from '../features/index.ts';

// What the page tells of its surroundings: the server, the browser's storage, the configuration of the folder.

/** Tells the user while the folder can't be reached, or this browser can't keep what is not saved. */
export function followSurroundings({ workspace, notices, journal }: Editor): void {
  let reportedLink = '';
  const tellLink = (link: Link) => {
    const text = link === 'up' ? '' : linkInWords(link, journal.state.getState().kind === 'working');
    if (text === reportedLink) return;
    reportedLink = text;
    if (text === '') notices.clear('server');
    else notices.show('warning', text, { topic: 'server' });
  };
  const tellJournal = () => {
    const state = journal.state.getState();
    tellLink(workspace.store.getState().link);
    if (state.kind === 'working') notices.clear('journal');
    else notices.show('warning', `${state.message}. ${state.hint}`, { topic: 'journal' });
  };
  journal.state.subscribe(tellJournal);
  tellJournal();
  workspace.store.subscribe(({ link }, before) => {
    if (link !== before.link) tellLink(link);
  });
}

/** What to do when the folder can't be reached, and where unsaved work is kept: browsers keep it per host and port. */
function linkInWords(link: Exclude<Link, 'up'>, isKept: boolean): string {
  const { host, port } = window.location;
  const gone = 'gq edit does not answer. Start it again in the same folder and open the address that it prints.';
  const other = 'gq edit was restarted, and this page belongs to the previous start: it can no longer save.';
  if (link === 'gone') {
    const kept = `Until then, your changes are kept in this browser for ${host}. They are not found under another port: start with gq edit --port ${port} to use this one.`;
    return `${gone} ${isKept ? kept : 'Your changes are lost when this page is closed: download the level first.'}`;
  }
  const comes = `Open the address that gq edit prints now. Unsaved changes are kept in this browser for ${host} and are restored if the new address has the same host and port.`;
  return `${other} ${isKept ? comes : 'Unsaved changes are lost when this page is closed: download the level, then open the address that gq edit prints now.'}`;
}

/** Called when the browser's database answers late: offers its levels together with those made in the meantime. */
export function offerLateLevels(editor: Editor, found: LevelStorage): void {
  const { workspace, notices } = editor;
  const takeOver = async () => {
    await workspace.store.getState().opened?.saver.flush();
    const list = await workspace.storage.list();
    const there = await found.list();
    if (!list.ok || !there.ok) return;
    const ids = new Set(there.value.levels.map(({ id }) => id));
    for (const { id } of list.value.levels) {
      const read = await workspace.storage.read(id);
      if (!read.ok || read.value.text === null) continue;
      let name = id;
      for (let i = 2; ids.has(name); i++) name = `${id}-${i}`;
      const written = await found.write(name, read.value.text, null);
      if (!written.ok) {
        notices.show('error', errorInWords(written.error), { topic: 'late' });
        return;
      }
      ids.add(name);
    }
    window.location.reload();
  };
  const text =
    'The browser’s database is available now. It may have levels that are not listed here. The levels of this page will be added to them.';
  notices.show('warning', text, {
    topic: 'late',
    actions: [{ title: 'Add them and reload', run: () => void takeOver() }],
  });
}

const TOPIC = 'configuration';

/** What a configuration sets, in words: `pull 45 px/s2, box width 24 px`. */
function rulesInWords(own: FolderTerms['rules']): string {
  const set = RULE_NAMES.flatMap((name) =>
    own[name] === undefined ? [] : `${ruleLabel(name)} ${own[name]} ${RULES[name].unit}`,
  );
  return set.length === 0 ? "the game's own rules" : set.join(', ');
}

/** What is different now, in words; empty: nothing that levels depend on. */
function changesInWords(now: FolderTerms, before: FolderTerms): string[] {
  const changes: string[] = [];
  if (now.rules !== before.rules) changes.push(`levels without rules of their own now use ${rulesInWords(now.rules)}`);
  if (now.accuracy !== before.accuracy) changes.push(`levels are now judged at ${now.accuracy}`);
  if (now.maxTime !== before.maxTime) changes.push(`a run may now last ${now.maxTime} s`);
  if (now.maxWork !== before.maxWork) changes.push(`a level may now cost ${now.maxWork} pieces of motion`);
  return changes;
}

/** Tells the user when the configuration of the folder changes, and shows an error while it is not valid. */
export function followConfiguration({ workspace, notices }: Editor): void {
  const tell = (now: FolderTerms, before: FolderTerms | null) => {
    if (now.problems.length > 0) {
      const wrong = problemsInWords(now.file ?? 'gq.config.json', now.problems);
      const inEffect = `Until this is fixed, levels are still judged at ${now.accuracy}, and use ${rulesInWords(now.rules)}.`;
      notices.show('error', `${wrong} ${inEffect}`, { topic: TOPIC });
      return;
    }
    notices.clear(TOPIC);
    const changes = before === null ? [] : changesInWords(now, before);
    if (changes.length === 0) return;
    const what = now.file === null ? 'gq.config.json was deleted' : `${now.file} has changed`;
    notices.show('info', `${what}: ${changes.join('; ')}.`, { topic: TOPIC });
  };
  workspace.store.subscribe((now, before) => {
    const terms = folderTermsIn(now);
    const known = before.list === null ? null : folderTermsIn(before);
    if (terms !== known) tell(terms, known);
  });
}

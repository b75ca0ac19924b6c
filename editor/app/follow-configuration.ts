import { type FolderTerms, RULE_NAMES, RULES } from '../../schema/index.ts';
import type { Editor } from '../core/context/index.ts';
import { folderTermsIn, problemsInWords } from '../core/files/index.ts';
import { ruleLabel } from '../features/index.ts';

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
    notices.settle(TOPIC);
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

import { type FolderRules, RULE_NAMES, RULES } from '../../schema/index.ts';
import type { Editor } from '../context/index.ts';
import { folderRulesIn, problemsInWords } from '../files/index.ts';
import { ruleLabel } from '../panels/inspector/index.ts';

const TOPIC = 'configuration';

/** What a configuration sets, in words: `pull 45 px/s2, box width 24 px`. */
function rulesInWords(own: FolderRules['own']): string {
  const set = RULE_NAMES.flatMap((name) =>
    own[name] === undefined ? [] : `${ruleLabel(name)} ${own[name]} ${RULES[name].unit}`,
  );
  return set.length === 0 ? "the game's own rules" : set.join(', ');
}

/** Tells the user when the configuration of the folder changes, and shows an error while it is not valid. */
export function followConfiguration({ workspace, notices }: Editor): void {
  const tell = (now: FolderRules, before: FolderRules | null) => {
    if (now.problems.length > 0) {
      const wrong = problemsInWords(now.file ?? 'gq.config.json', now.problems);
      const inEffect = `Until this is fixed, levels still use ${rulesInWords(now.own)}.`;
      notices.show('error', `${wrong} ${inEffect}`, { topic: TOPIC });
      return;
    }
    notices.settle(TOPIC);
    if (before === null || now.own === before.own) return;
    const what = now.file === null ? 'gq.config.json was deleted' : `${now.file} has changed`;
    notices.show('info', `${what}: levels without rules of their own now use ${rulesInWords(now.own)}.`, { topic: TOPIC });
  };
  workspace.store.subscribe((now, before) => {
    const rules = folderRulesIn(now);
    const known = before.list === null ? null : folderRulesIn(before);
    if (rules !== known) tell(rules, known);
  });
}

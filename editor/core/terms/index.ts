import { createStore, type StoreApi } from 'zustand/vanilla';
import { ACCURACIES, type AccuracyName, type Terms } from '../../../engine/index.ts';
import { type FolderTerms, RULE_NAMES } from '../../../schema/index.ts';
import { folderTermsIn, type Workspace } from '../files/index.ts';
import type { SettingsStore } from '../settings/index.ts';

/** The terms of the page. */
export interface PageTerms {
  /** Those of the folder, under which `gq check` judges its levels. */
  readonly folder: Terms;
  /** Those under which the open level is shown: the folder's, perhaps at another accuracy that the person has chosen. */
  readonly shown: Terms;
}

export type TermsStore = StoreApi<PageTerms>;

/** Only what a level's answers depend on: whether the configuration has a problem does not matter to them. */
function judged({ accuracy, maxTime, maxWork, rules }: FolderTerms, before: Terms | null): Terms {
  const isSame =
    before?.accuracy.name === accuracy && before.maxTime === maxTime && before.maxWork === maxWork && before.rules === rules;
  return isSame ? before : { accuracy: ACCURACIES[accuracy], maxTime, maxWork, rules };
}

/** The terms of the page, which follow the folder and the settings. Equal terms stay the same object. */
export function createPageTerms(workspace: Pick<Workspace, 'store'>, settings: SettingsStore): TermsStore {
  const now = (before: PageTerms | null): PageTerms => {
    const folder = judged(folderTermsIn(workspace.store.getState()), before?.folder ?? null);
    const { otherAccuracy } = settings.getState();
    const shown = otherAccuracy === null ? folder : termsAt(folder, otherAccuracy);
    if (before === null || before.folder !== folder) return { folder, shown };
    return before.shown.accuracy === shown.accuracy ? before : { folder, shown };
  };
  const store = createStore<PageTerms>(() => now(null));
  const update = () => {
    const before = store.getState();
    const next = now(before);
    if (next !== before) store.setState(next, true);
  };
  workspace.store.subscribe(update);
  settings.subscribe(update);
  return store;
}

/** The same terms at another accuracy. */
export const termsAt = (terms: Terms, accuracy: AccuracyName): Terms =>
  terms.accuracy.name === accuracy ? terms : { ...terms, accuracy: ACCURACIES[accuracy] };

/** Everything that terms say, as a key: what is kept about a level is kept under it. */
export const termsKey = ({ accuracy, maxTime, maxWork, rules }: Terms): string =>
  `${accuracy.name} ${maxTime} ${maxWork} ${RULE_NAMES.map((name) => rules[name])}`;

/** Whether the open level is shown at another accuracy than that of the folder. */
export const isOtherAccuracy = ({ folder, shown }: PageTerms): boolean => folder.accuracy !== shown.accuracy;

/** At which accuracy the open level is shown: `precise`, or `at precise; gq check here: arcade`. */
export const termsInWords = (terms: PageTerms): string =>
  isOtherAccuracy(terms)
    ? `at ${terms.shown.accuracy.name}; gq check here: ${terms.folder.accuracy.name}`
    : terms.folder.accuracy.name;

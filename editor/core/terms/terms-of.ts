import { ACCURACIES, type AccuracyName, isAccuracyName, type Terms } from '../../../engine/index.ts';
import { RULE_NAMES } from '../../../schema/index.ts';

/** The same terms at another accuracy. */
export const termsAt = (terms: Terms, accuracy: AccuracyName): Terms =>
  terms.accuracy.name === accuracy ? terms : { ...terms, accuracy: ACCURACIES[accuracy] };

/** The name of the accuracy: the page knows no custom settings. */
export function accuracyNameOf({ accuracy: { name } }: Pick<Terms, 'accuracy'>): AccuracyName {
  if (!isAccuracyName(name)) throw new Error(`expected a named accuracy, found ${name}`);
  return name;
}

/** Everything that terms say, as a key: what is kept about a level is kept under it. */
export const termsKey = ({ accuracy, maxTime, maxWork, rules }: Terms): string =>
  `${accuracy.name} ${maxTime} ${maxWork} ${RULE_NAMES.map((name) => rules[name])}`;

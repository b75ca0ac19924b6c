import { ACCURACIES, type AccuracyName, type Terms } from '../../../engine/index.ts';
import { RULE_NAMES } from '../../../schema/index.ts';

/** The same terms at another accuracy. */
export const termsAt = (terms: Terms, accuracy: AccuracyName): Terms =>
  terms.accuracy.name === accuracy ? terms : { ...terms, accuracy: ACCURACIES[accuracy] };

/** Everything that terms say, as a key: what is kept about a level is kept under it. */
export const termsKey = ({ accuracy, maxTime, maxWork, rules }: Terms): string =>
  `${accuracy.name} ${maxTime} ${maxWork} ${RULE_NAMES.map((name) => rules[name])}`;

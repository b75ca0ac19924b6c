import { ACCURACIES, type Accuracy, nameOfSetting, type Setting } from './accuracy.ts';
import { validSetting } from './valid-accuracy.ts';

const sameSetting = (a: Setting, b: Setting): boolean =>
  a.integrator === b.integrator && a.rate === b.rate && a.tolerance === b.tolerance && a.contact === b.contact;

/**
 * Makes an accuracy of its settings.
 *
 * @param setting - integrator, rate (Hz) or tolerance (px), and contact test
 * @returns the named accuracy with these settings if there is one, otherwise one that is named after its settings
 * @throws {RangeError} when the settings contradict each other, or are not within {@link ACCURACY_LIMITS}
 */
export function accuracyOf(setting: Setting): Accuracy {
  const valid = validSetting(setting);
  return (
    Object.values<Accuracy>(ACCURACIES).find((named) => sameSetting(valid, named)) ?? { name: nameOfSetting(valid), ...valid }
  );
}

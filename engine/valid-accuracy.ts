import {
  ACCURACIES,
  ACCURACY_LIMITS,
  type Accuracy,
  type AccuracyName,
  isAccuracyName,
  nameOfSetting,
  type Setting,
} from './accuracy.ts';

const NAMES = Object.keys(ACCURACIES).join(', ');

/** A value in an error; an accuracy may come from code without types. */
function found(value: unknown): string {
  if (value === undefined) return 'nothing';
  return typeof value === 'string'
    ? JSON.stringify(value)
    : typeof value === 'object' && value !== null
      ? 'an object'
      : `${value}`;
}

/**
 * Tests an accuracy that somebody gave: nothing about it may be left to chance, since a run under a malformed one goes anywhere.
 *
 * @param accuracy - a name, or a setting; a rate or tolerance that is left out counts as null, and a name may be missing
 * @returns the accuracy, with every member
 * @throws {RangeError} when it is none: says what was expected and what was found
 */
export function validAccuracy(accuracy: AccuracyName | Accuracy): Accuracy {
  if (typeof accuracy === 'string') {
    if (isAccuracyName(accuracy)) return ACCURACIES[accuracy];
    throw new RangeError(`accuracy: expected ${NAMES}, or a custom setting of accuracyOf, found ${found(accuracy)}`);
  }
  if (typeof accuracy !== 'object' || accuracy === null) {
    throw new RangeError(`accuracy: expected ${NAMES}, or a custom setting of accuracyOf, found ${found(accuracy)}`);
  }
  const setting = validSetting(accuracy);
  const { name } = accuracy;
  const isComplete = typeof name === 'string' && accuracy.rate === setting.rate && accuracy.tolerance === setting.tolerance;
  return isComplete ? accuracy : { name: typeof name === 'string' ? name : nameOfSetting(setting), ...setting };
}

/**
 * Tests the members of an accuracy.
 *
 * @param setting - the setting; a rate or tolerance that is left out counts as null
 * @returns the setting without anything else
 * @throws {RangeError} when it is none
 */
export function validSetting(setting: Setting): Setting {
  const { integrator, contact } = setting;
  const rate = setting.rate ?? null;
  const tolerance = setting.tolerance ?? null;
  if (!['arcade', 'euler', 'verlet', 'rk4', 'taylor'].includes(integrator)) {
    throw new RangeError(`accuracy, integrator: expected arcade, euler, verlet, rk4 or taylor, found ${found(integrator)}`);
  }
  if (contact !== 'frame' && contact !== 'swept') {
    throw new RangeError(`accuracy, contact: expected "frame" or "swept", found ${found(contact)}`);
  }
  const valid: Setting = { integrator, rate, tolerance, contact };
  if (integrator === 'arcade') {
    const own = ACCURACIES.arcade;
    if (rate === own.rate && tolerance === own.tolerance && contact === own.contact) return valid;
    throw new RangeError(`accuracy: arcade has 60 frames per second and no other setting: expected the name "arcade"`);
  }
  const [size, unit, other] =
    integrator === 'taylor' ? (['tolerance', 'px', 'rate'] as const) : (['rate', 'Hz', 'tolerance'] as const);
  if (valid[other] !== null) {
    const why = integrator === 'taylor' ? 'chooses its own steps' : 'has fixed steps';
    throw new RangeError(
      `accuracy, ${other}: ${integrator} ${why}: expected null, and a ${size} instead, found ${found(valid[other])}`,
    );
  }
  const { least, most } = ACCURACY_LIMITS[size];
  const value: unknown = valid[size];
  if (typeof value === 'number' && value >= least && value <= most) return valid;
  throw new RangeError(`accuracy, ${size}: expected ${least} to ${most} ${unit} for ${integrator}, found ${found(value)}`);
}

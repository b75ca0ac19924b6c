import { KINDS, type LevelFile, objectName, RULES, resolveLevel } from '../../schema/index.ts';
import { plural, proposalInWords } from '../words/index.ts';
import type { Mended } from './mend.ts';
import { distanceOf, type TakenBack, valueAfter } from './take-back.ts';
import { isMove, isNumeric, type Unit } from './units.ts';

/**
 * What mends a level, as an instruction.
 * @param after the file that is mended
 */
export const mendedInWords = ({ how }: Mended, after: LevelFile): string =>
  how.kind === 'back' ? takenBackInWords(how.taken, after) : proposalInWords(resolveLevel(after), how.proposal);

const number = (value: number): string => String(Math.round(value * 100) / 100);
const px = (value: number): string => `${Math.round(value * 10) / 10} px`;

/** The object of a unit: `asteroid 3`, `the start`, `the black hole`. */
function objectOf(unit: Unit, after: LevelFile): string {
  if (unit.what === 'rule' || unit.what === 'range' || (unit.what === 'flag' && unit.kind === null)) return 'the level';
  const { kind, index } = unit as Extract<Unit, { kind: unknown; index: number }> & { kind: keyof typeof KINDS };
  if (kind === 'astronaut') return 'the start';
  if (kind === 'blackHole') return 'the black hole';
  const { list } = KINDS[kind];
  const written = unit.what === 'removed' ? unit.object : ((after as never)[list as never] as object[] | undefined)?.[index];
  return objectName(kind, index, written ?? {});
}

function unitInWords(unit: Unit, share: number, after: LevelFile): string {
  const object = objectOf(unit, after);
  if (unit.what === 'added') return `Remove ${object} again`;
  if (unit.what === 'removed') return `Put ${object} back`;
  if (unit.what === 'flag') return `Switch ${unit.key} of ${object} back`;
  if (isMove(unit)) {
    return share === 1 ? `Move ${object} back to where it was` : `Move ${object} back by ${px(distanceOf(unit, share))}`;
  }
  const [one] = unit.numbers;
  const to = share === 1 ? one.was : valueAfter(one, share, false);
  if (unit.what === 'object' && unit.numbers.length > 1) {
    return share === 1 ? `Take the change of ${object} back` : `Take ${percent(share)} of the change of ${object} back`;
  }
  if (unit.what === 'object' && one.key !== KINDS[unit.kind].radius) {
    return `Set ${one.key} of ${object} back to ${number(to)}, from ${number(one.now)}`;
  }
  if (unit.what === 'rule') {
    return `Set ${one.key} back to ${number(to)} ${RULES[one.key as keyof typeof RULES].unit}, from ${number(one.now)}`;
  }
  const what = unit.what === 'range' ? 'the range' : object;
  return `Make ${what} ${to > one.now ? 'larger' : 'smaller'} again by ${px(Math.abs(to - one.now))}`;
}

const percent = (share: number): string => `${Math.round(100 * share)} %`;

/**
 * What is taken back of a change, as an instruction: `Move asteroid 3 back by 9 px.`
 * @param after the file after the change
 */
function takenBackInWords({ units, share }: TakenBack, after: LevelFile): string {
  if (units.length === 1) return `${unitInWords(units[0], share, after)}.`;
  if (units.every(isMove)) {
    const distances = units.map((unit) => distanceOf(unit, share));
    const [least, most] = [Math.min(...distances), Math.max(...distances)];
    const by = most - least < 0.5 ? `by ${px(most)}` : `by ${number(Math.round(least * 10) / 10)} to ${px(most)}`;
    return share === 1
      ? `Move ${plural(units.length, 'object')} back to where they were.`
      : `Move ${plural(units.length, 'object')} back ${by}.`;
  }
  return share === 1 || !units.some(isNumeric)
    ? `Take all ${units.length} changes back.`
    : `Take ${percent(share)} of all ${units.length} changes back.`;
}

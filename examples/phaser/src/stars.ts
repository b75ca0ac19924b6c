import { element } from './dom.ts';
import { count } from './words.ts';

/** More stars than this are shown as a number. */
const MOST_SHOWN = 6;

/**
 * Minerals as stars.
 * @param lit how many are collected; null: the level has not been completed
 */
export function starRow(lit: number | null, all: number): HTMLElement {
  const label = lit === null ? count(all, 'star') : `${lit} of ${count(all, 'star')}`;
  const row = element('span', { class: 'stars', role: 'img', 'aria-label': label });
  if (all > MOST_SHOWN) {
    const star = element('span', { class: (lit ?? 0) > 0 ? 'star lit' : 'star' }, '★');
    row.append(star, element('span', { class: 'numbers' }, ` ${lit ?? 0}/${all}`));
  } else {
    for (let i = 0; i < all; i++) row.append(element('span', { class: i < (lit ?? 0) ? 'star lit' : 'star' }, '★'));
  }
  return row;
}

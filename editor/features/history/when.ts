const DAY = 24 * 3_600_000;

const twoDigits = (n: number): string => String(n).padStart(2, '0');

/** The time of day, of this machine: `14:32`. @param time ms since 1970 */
export const clockTime = (time: number): string => {
  const date = new Date(time);
  return `${twoDigits(date.getHours())}:${twoDigits(date.getMinutes())}`;
};

// not by the browser's locale: the page speaks English, and browsers differ in commas
const WEEKDAYS = ['Sunday', 'Monday', 'Tuesday', 'Wednesday', 'Thursday', 'Friday', 'Saturday'];
const MONTHS = [
  ...['January', 'February', 'March', 'April', 'May', 'June'],
  ...['July', 'August', 'September', 'October', 'November', 'December'],
];

/** `23 November 2026` */
const dateInWords = (date: Date): string => `${date.getDate()} ${MONTHS[date.getMonth()]} ${date.getFullYear()}`;

const midnight = (time: number): number => new Date(time).setHours(0, 0, 0, 0);

/** The day of a time: `Today`, `Yesterday`, `Monday, 23 November 2026`. @param now ms since 1970 */
export function dayInWords(time: number, now: number): string {
  // the days around a change of the clocks have 23 and 25 hours
  const days = Math.round((midnight(now) - midnight(time)) / DAY);
  if (days === 0) return 'Today';
  if (days === 1) return 'Yesterday';
  const date = new Date(time);
  return `${WEEKDAYS[date.getDay()]}, ${dateInWords(date)}`;
}

/** A day and a time: `14:32`, `yesterday 14:32`, `23 November 2026, 14:32`. */
export function momentInWords(time: number, now: number): string {
  const day = dayInWords(time, now);
  if (day === 'Today') return clockTime(time);
  if (day === 'Yesterday') return `yesterday ${clockTime(time)}`;
  return `${dateInWords(new Date(time))}, ${clockTime(time)}`;
}

const UNITS = [
  ['day', DAY],
  ['hour', 3_600_000],
  ['minute', 60_000],
] as const;

/** How long ago: `5 minutes ago`, `just now`. */
export function agoInWords(time: number, now: number): string {
  for (const [unit, ms] of UNITS) {
    const count = Math.floor((now - time) / ms);
    if (count > 0) return `${count} ${unit}${count === 1 ? '' : 's'} ago`;
  }
  return 'just now';
}

import { formatLevel, type Level, type LevelFile, type LevelReading, readLevel } from 'gravity-quest-toolkit/schema';

/** What is read of the level, and of a file that is none. */
export function trial(text: string): string {
  const read: LevelReading = readLevel(text);
  if (!read.ok) throw new Error(read.problems[0].message);
  const level: Level = read.level;
  const file: LevelFile = JSON.parse(text);
  // @ts-expect-error: the types are known, and this is none of them
  const name: number = level.name;
  const wrong = readLevel('{ "version": 1 }');
  const code = wrong.ok ? 'none' : wrong.problems[0].code;
  return `${name} ${formatLevel(file) === text} ${level.asteroids.length} ${code}`;
}

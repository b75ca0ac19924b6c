let waiting = '';

/** Adds a line for stderr, which is written with the messages of the command once it is done. */
export function notice(line: string): void {
  waiting += line;
}

/** The lines since the last call. */
export function takeNotices(): string {
  const lines = waiting;
  waiting = '';
  return lines;
}

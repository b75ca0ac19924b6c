interface ProgressProps {
  readonly label: string;
  readonly isRunning: boolean;
  /** 0 to 1; absent if the duration is unknown. */
  readonly share?: number;
}

/** A progress bar. It keeps its space when it is over, so that controls below do not move under the pointer. */
export function Progress({ label, isRunning, share }: ProgressProps) {
  // Without a value it would keep animating, unseen.
  return (
    <progress className={isRunning ? 'progress' : 'progress progress--over'} aria-label={label} value={isRunning ? share : 1} />
  );
}

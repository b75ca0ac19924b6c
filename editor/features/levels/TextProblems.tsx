import { CircleCheck, TriangleAlert } from 'lucide-react';
import type { Problem } from '../../../schema/index.ts';

interface TextProblemsProps {
  readonly problems: readonly Problem[];
  /** Moves to a place in the text. */
  readonly onGoTo: (line: number, column: number) => void;
}

/** The problems of a level's text, or that it is valid. */
export function TextProblems({ problems, onGoTo }: TextProblemsProps) {
  if (problems.length === 0) {
    return (
      <p className="astext__fine">
        <CircleCheck size={14} aria-hidden /> A valid level.
      </p>
    );
  }
  return (
    <ul className="astext__problems" aria-label="Problems">
      {problems.map(({ code, pointer, line, column, message, hint }) => (
        <li key={`${code} ${pointer} ${line} ${column}`}>
          <button type="button" className="astext__problem" onClick={() => onGoTo(line ?? 1, column ?? 1)}>
            <TriangleAlert size={13} aria-hidden />
            {line !== null && (
              <span className="astext__place">
                {line}:{column}
              </span>
            )}
            <span>
              {message} <span className="astext__hint">{hint}</span>
            </span>
          </button>
        </li>
      ))}
    </ul>
  );
}

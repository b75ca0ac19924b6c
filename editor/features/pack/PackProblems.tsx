import { CircleAlert, TriangleAlert } from 'lucide-react';
import type { Problem } from '../../../schema/index.ts';
import { Button } from '../../core/ui/index.ts';

interface PackProblemsProps {
  readonly file: string;
  readonly problems: readonly Problem[];
  /** null: there is nothing to go to. */
  readonly onGo: ((problem: Problem) => void) | null;
}

/** What `gq check` says of the order, in the same words, with a way to each place. */
export function PackProblems({ file, problems, onGo }: PackProblemsProps) {
  if (problems.length === 0) return null;
  return (
    <section className="pack__problems" aria-label="Problems of the order">
      <ul>
        {problems.map((problem) => {
          const { code, severity, message, hint, line, column } = problem;
          const Icon = severity === 'error' ? CircleAlert : TriangleAlert;
          return (
            <li key={`${code} ${line}:${column}`} className={`pack__problem pack__problem--${severity}`}>
              <Icon size={15} aria-label={severity} />
              <div>
                <p>{message}</p>
                <p className="pack__note">
                  {hint} <span className="pack__place">{line === null ? file : `${file}:${line}:${column}`}</span>{' '}
                  <code>{code}</code>
                </p>
              </div>
              {onGo !== null && (
                <Button hint="Show it" aria-label={`Go to: ${message}`} look="outlined" onClick={() => onGo(problem)}>
                  Go to
                </Button>
              )}
            </li>
          );
        })}
      </ul>
    </section>
  );
}

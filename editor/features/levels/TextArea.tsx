import { type Ref, useImperativeHandle, useRef } from 'react';
import type { Problem } from '../../../schema/index.ts';

export interface TextAreaHandle {
  /** Line and column count from 1. */
  goTo(line: number, column: number): void;
}

interface TextAreaProps {
  readonly ref: Ref<TextAreaHandle>;
  readonly label: string;
  readonly text: string;
  readonly problems: readonly Problem[];
  readonly onChange: (text: string) => void;
  readonly onSave: () => void;
}

/** px; repeated in the style sheet */
const LINE = 18;

/** A text area with line numbers; lines with a problem are marked. */
export function TextArea({ ref, label, text, problems, onChange, onSave }: TextAreaProps) {
  const field = useRef<HTMLTextAreaElement>(null);
  const numbers = useRef<HTMLDivElement>(null);
  const marked = new Set(problems.map(({ line }) => line));
  const lines = text.split('\n').length;
  useImperativeHandle(ref, () => ({
    goTo(line, column) {
      const element = field.current;
      if (element === null) return;
      const before = element.value.split('\n').slice(0, line - 1);
      const at = before.reduce((sum, one) => sum + one.length + 1, 0) + column - 1;
      element.focus();
      element.setSelectionRange(at, at);
      element.scrollTop = Math.max(0, (line - 6) * LINE);
    },
  }));
  return (
    <div className="astext">
      <div ref={numbers} className="astext__numbers" aria-hidden>
        {Array.from({ length: lines }, (_, i) => (
          // biome-ignore lint/suspicious/noArrayIndexKey: a line is known by its number alone
          <div key={i} className={marked.has(i + 1) ? 'astext__number astext__number--bad' : 'astext__number'}>
            {i + 1}
          </div>
        ))}
      </div>
      <textarea
        ref={field}
        className="astext__text"
        aria-label={label}
        aria-invalid={problems.length > 0}
        value={text}
        wrap="off"
        spellCheck={false}
        autoCapitalize="off"
        onChange={(event) => onChange(event.target.value)}
        onScroll={(event) => {
          if (numbers.current !== null) numbers.current.scrollTop = event.currentTarget.scrollTop;
        }}
        onKeyDown={(event) => {
          if (!(event.ctrlKey || event.metaKey) || event.key.toLowerCase() !== 's') return;
          event.preventDefault();
          onSave();
        }}
      />
    </div>
  );
}

import { useEffect, useId, useRef, useState } from 'react';

interface InlineNameProps {
  readonly label: string;
  readonly value: string;
  readonly longest: number;
  /**
   * Why a name is refused, and what to do; null if it is fine. A refused name stays in the field until it is corrected or Esc
   * cancels.
   */
  readonly problemOf: (name: string) => string | null;
  /** Called on Enter or blur, only with a changed name. */
  readonly onDone: (name: string) => void;
  /** Called when the field should close, with or without a change. */
  readonly onEnd: () => void;
}

/** A field that edits a name in its row. */
export function InlineName({ label, value, longest, problemOf, onDone, onEnd }: InlineNameProps) {
  const [text, setText] = useState(value);
  const input = useRef<HTMLInputElement>(null);
  const note = useRef<HTMLSpanElement>(null);
  const id = useId();
  // The tree had the focus and gets it back; the blur caused by Esc must not count as done.
  const over = useRef(false);
  useEffect(() => {
    const tree = input.current?.closest<HTMLElement>('[role=tree]');
    // A menu that has just closed restores the focus first.
    const frame = requestAnimationFrame(() => {
      input.current?.focus();
      input.current?.select();
    });
    return () => {
      cancelAnimationFrame(frame);
      if (document.activeElement === null || document.activeElement === document.body) tree?.focus({ preventScroll: true });
    };
  }, []);
  const name = text.trim();
  const problem = name === value ? null : problemOf(name);
  const hasProblem = problem !== null;
  useEffect(() => {
    if (hasProblem) note.current?.scrollIntoView({ block: 'nearest' });
  }, [hasProblem]);
  const end = (keep: boolean) => {
    if (over.current || (keep && hasProblem)) return;
    over.current = true;
    if (keep && name !== value) onDone(name);
    onEnd();
  };
  return (
    <span className="tree__rename">
      <input
        ref={input}
        className="field tree__name"
        aria-label={label}
        aria-invalid={hasProblem}
        aria-describedby={hasProblem ? id : undefined}
        value={text}
        maxLength={longest}
        spellCheck={false}
        onChange={(event) => setText(event.target.value)}
        onBlur={() => end(true)}
        onClick={(event) => event.stopPropagation()}
        onDoubleClick={(event) => event.stopPropagation()}
        onContextMenu={(event) => event.stopPropagation()}
        onKeyDown={(event) => {
          event.stopPropagation();
          if (event.key === 'Enter') end(true);
          else if (event.key === 'Escape') end(false);
        }}
      />
      {hasProblem && (
        <span ref={note} id={id} className="tree__problem" role="alert">
          {problem}
        </span>
      )}
    </span>
  );
}

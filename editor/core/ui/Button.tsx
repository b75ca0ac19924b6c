import type { ButtonHTMLAttributes, ReactNode } from 'react';
import { Hint } from './Hint.tsx';

interface ButtonProps extends Omit<ButtonHTMLAttributes<HTMLButtonElement>, 'title'> {
  /** What it does, for the tooltip; also its accessible name if it has no text. */
  readonly hint: string;
  /** The key as it is displayed. */
  readonly shortcut?: string;
  /** Where the tooltip stands if there is room; above if absent. */
  readonly hintSide?: 'left';
  readonly icon?: ReactNode;
  readonly look?: 'plain' | 'outlined' | 'main' | 'danger';
  readonly pressed?: boolean;
}

/** A button with a tooltip; without a text, its hint is its accessible name. */
export function Button({
  hint,
  hintSide,
  shortcut,
  icon,
  look = 'plain',
  pressed,
  children,
  className = '',
  ...rest
}: ButtonProps) {
  const bare = children === undefined || children === null;
  const classes = `button button--${look}${bare ? ' button--bare' : ''} ${className}`.trim();
  return (
    <Hint text={hint} shortcut={shortcut} side={hintSide}>
      <button type="button" className={classes} aria-label={bare ? hint : undefined} aria-pressed={pressed} {...rest}>
        {icon}
        {children}
      </button>
    </Hint>
  );
}

import { X } from 'lucide-react';
import { Dialog as Radix, Tooltip } from 'radix-ui';
import type { ButtonHTMLAttributes, ReactNode } from 'react';

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

interface HintProps {
  readonly text: string;
  readonly shortcut?: string;
  /** Where it stands if there is room; above if absent. In a list, what stands above is the next thing to press. */
  readonly side?: 'left' | undefined;
  readonly children: ReactNode;
}

/** A tooltip for the one element inside. */
export function Hint({ text, shortcut, side, children }: HintProps) {
  return (
    <Tooltip.Root>
      <Tooltip.Trigger asChild>{children}</Tooltip.Trigger>
      <Tooltip.Portal>
        <Tooltip.Content className="tooltip" side={side} sideOffset={6} collisionPadding={8}>
          {text}
          {shortcut !== undefined && <kbd>{shortcut}</kbd>}
        </Tooltip.Content>
      </Tooltip.Portal>
    </Tooltip.Root>
  );
}

interface DialogProps {
  readonly open: boolean;
  readonly title: string;
  /** A sentence below the title. */
  readonly about: string;
  readonly wide?: boolean;
  readonly onClose: () => void;
  readonly children: ReactNode;
}

/** A modal dialog: it traps the focus, Esc closes it, and the focus returns to where it was. */
export function Dialog({ open, title, about, wide = false, onClose, children }: DialogProps) {
  return (
    <Radix.Root open={open} onOpenChange={(next) => !next && onClose()}>
      <Radix.Portal>
        <Radix.Overlay className="dialog__shade" />
        <Radix.Content
          className={wide ? 'dialog dialog--wide' : 'dialog'}
          onOpenAutoFocus={(event) => {
            // a focused button would show its tooltip, and Esc would close only that
            event.preventDefault();
            const content = event.currentTarget as HTMLElement;
            const first = content.querySelector<HTMLElement>('input:not([type=file]), select, textarea');
            (first ?? content).focus();
          }}
          onCloseAutoFocus={(event) => {
            // the action that closed it may have set the focus, or keepFocus has
            if (document.activeElement !== document.body) event.preventDefault();
          }}
        >
          <div className="dialog__head">
            <div>
              <Radix.Title className="dialog__title">{title}</Radix.Title>
              <Radix.Description className="dialog__about">{about}</Radix.Description>
            </div>
            <Button hint="Close" shortcut="Esc" icon={<X size={16} />} onClick={onClose} />
          </div>
          {children}
        </Radix.Content>
      </Radix.Portal>
    </Radix.Root>
  );
}

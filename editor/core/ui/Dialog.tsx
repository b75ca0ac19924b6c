import { X } from 'lucide-react';
import { Dialog as Radix } from 'radix-ui';
import type { ReactNode } from 'react';
import { Button } from './Button.tsx';

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

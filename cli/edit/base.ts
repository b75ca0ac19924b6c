/** What a change is based on: the etag of the content that the client knows, or that there is no such file. */
export type Base = { readonly etag: string } | 'no-file';

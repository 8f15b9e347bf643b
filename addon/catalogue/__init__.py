"""Every preset of every model: what it is called, what sort of thing it is, how it is found.  numpy only."""

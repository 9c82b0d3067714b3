# CalculiX's usermpc.f, so that several user MPCs may begin with the same node: each eliminates at first the lowest of its degrees of
# freedom that no other one does.
0,/if(nnodes.eq.1) then/s//&\n            idir=1/
/^ *idof=8\*(node-1)+1 *$/,/call nident(ikmpc,idof,nmpc,id)/c\
               do idir=1,3\
                  idof=8*(node-1)+idir\
                  call nident(ikmpc,idof,nmpc,id)\
                  if(id.eq.0) exit\
                  if(ikmpc(id).ne.idof) exit\
               enddo
s/nodempc(2,mpcfree)=1 *$/nodempc(2,mpcfree)=idir/
